// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Hertz' contact radius, and the network of contacts as a sparse matrix.
#include "coupling/step/contactConduction.H"

#include "coupling/step/heatBalance.H"

#include <Eigen/SparseCholesky>

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// (1 - nu^2)/E [1/Pa]
scalar compliance(const GrainHeatProperties& material) { return (1 - sqr(material.poissonRatio))/material.youngModulus; }

const GrainHeatProperties& propertiesOf(const HeatSettings& settings, const ::nscd::Grains& grains, std::size_t i)
{
    return settings.materials[std::size_t(grains.material[i])];
}

/// T^{n+1} of backward Euler. The row of a held grain says that its temperature stays; its neighbors have that on their right-hand side.
Eigen::VectorXd endTemperatures
(
    const HeatSettings& settings, const ::nscd::Grains& grains, const std::vector<ContactConductance>& contacts,
    const std::vector<scalar>& temperature, scalar deltaT
)
{
    const auto n = Eigen::Index(grains.nOwned);
    const auto isHeld = [&](std::size_t i) { return propertiesOf(settings, grains, i).isHeld; };
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(n);
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const scalar storage = isHeld(i) ? 1 : heatCapacityOf(settings, grains, i)/deltaT;
        entries.emplace_back(i, i, storage);
        right[Eigen::Index(i)] = storage*temperature[i];
    }
    for (const ContactConductance& contact : contacts)
    {
        for (const auto& [i, j] : {std::pair(contact.a, contact.b), std::pair(contact.b, contact.a)})
        {
            if (isHeld(i)) continue;
            entries.emplace_back(i, i, contact.conductance);
            if (isHeld(j)) right[Eigen::Index(i)] += contact.conductance*temperature[j];
            else entries.emplace_back(i, j, -contact.conductance);
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
}

} // namespace


scalar contactConductance
(
    const GrainHeatProperties& a, const GrainHeatProperties& b, scalar radiusA, scalar radiusB, scalar normalForce
)
{
    const scalar radius = 1/(1/radiusA + 1/radiusB);
    const scalar spot = std::cbrt(0.75*normalForce*radius*(compliance(a) + compliance(b)));
    return 4*a.conductivity*b.conductivity/(a.conductivity + b.conductivity)*spot;
}


std::vector<ContactConductance> contactConductances
(
    const HeatSettings& settings, const ::nscd::Grains& grains, const std::vector<::nscd::LoadedContact>& contacts, scalar deltaT
)
{
    std::vector<ContactConductance> found;
    for (const ::nscd::LoadedContact& contact : contacts)
    {
        const scalar force = contact.impulse.dot(contact.normal)/deltaT;
        if (contact.b < 0 || !(force > 0)) continue;
        const auto a = std::size_t(contact.a), b = std::size_t(contact.b);
        found.push_back({a, b, contactConductance
        (
            propertiesOf(settings, grains, a), propertiesOf(settings, grains, b), grains.radius[a], grains.radius[b], force
        )});
    }
    return found;
}


std::vector<scalar> conductedHeat
(
    const HeatSettings& settings, const ::nscd::Grains& grains, const std::vector<ContactConductance>& contacts,
    const std::vector<scalar>& temperature, scalar deltaT
)
{
    std::vector<scalar> heat(grains.nOwned, 0.0);
    if (contacts.empty()) return heat;
    const Eigen::VectorXd end = endTemperatures(settings, grains, contacts, temperature, deltaT);
    for (const ContactConductance& contact : contacts)
    {
        const scalar toA = deltaT*contact.conductance*(end[Eigen::Index(contact.b)] - end[Eigen::Index(contact.a)]);
        heat[contact.a] += toA;
        heat[contact.b] -= toA;
    }
    return heat;
}

} // namespace nscdCoupling
} // namespace Foam
