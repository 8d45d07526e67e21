// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Hertz' contact radius, and conjugate gradients over the contacts of all ranks.
#include "coupling/step/contactConduction.H"

#include "coupling/step/heatBalance.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using Eigen::ArrayXd;
using Eigen::Index;

/// Steps of the preconditioner below this share of the largest temperature are round-off.
constexpr scalar roundOff = 1e-14;
/// Reached by none but steps of a million times what a grain takes to warm through its contacts.
constexpr int maxIterations = 10000;

/// (1 - nu^2)/E [1/Pa]
scalar compliance(const GrainHeatProperties& material) { return (1 - sqr(material.poissonRatio))/material.youngModulus; }

const GrainHeatProperties& propertiesOf(const HeatSettings& settings, int material) { return settings.materials[std::size_t(material)]; }

/// What is left in the equations, over all ranks.
struct Residual
{
    scalar energy;    ///< product of what is left and the step that the preconditioner makes of it [J K]
    scalar largest;   ///< of such steps [K]
};

/// Over all ranks.
scalar largestSize(const ArrayXd& values, const ::nscd::Exchange& exchange)
{
    scalar largest = values.size() > 0 ? values.abs().maxCoeff() : 0;
    exchange.max(&largest, 1);
    return largest;
}

Residual residualOf(const ArrayXd& left, const ArrayXd& step, const ::nscd::Exchange& exchange)
{
    double sums[2] = {(left*step).sum(), 0}, largest = step.size() > 0 ? step.abs().maxCoeff() : 0;
    exchange.sumAndMax(sums, largest);
    return {sums[0], largest};
}

scalar sumOverRanks(scalar value, const ::nscd::Exchange& exchange)
{
    exchange.sum(&value, 1);
    return value;
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
    const HeatSettings& settings, const ::nscd::Grains& grains, const std::vector<::nscd::GhostGrain>& ghosts,
    const std::vector<::nscd::LoadedContact>& contacts, scalar deltaT
)
{
    const auto materialOf = [&](std::size_t i) { return i < grains.nOwned ? grains.material[i] : ghosts[i - grains.nOwned].material; };
    std::vector<ContactConductance> found;
    for (const ::nscd::LoadedContact& contact : contacts)
    {
        const scalar force = contact.impulse.dot(contact.normal)/deltaT;
        if (contact.b < 0 || !(force > 0)) continue;
        const auto a = std::size_t(contact.a), b = std::size_t(contact.b);
        found.push_back({a, b, contactConductance
        (
            propertiesOf(settings, materialOf(a)), propertiesOf(settings, materialOf(b)), grains.radius[a], contact.radiusB, force
        )});
    }
    return found;
}


ContactConduction::ContactConduction
(
    const HeatSettings& settings, const ::nscd::Grains& grains, std::vector<ContactConductance> contacts,
    const std::vector<::nscd::GhostGrain>& ghosts, ::nscd::Exchange& exchange
)
:
    contacts_(std::move(contacts)),
    exchange_(exchange),
    nGhosts_(Index(ghosts.size())),
    shared_(exchange.connect(ghosts)),
    capacity_(Index(grains.nOwned)),
    isFree_(Index(grains.nOwned))
{
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        capacity_[Index(i)] = heatCapacityOf(settings, grains, i);
        isFree_[Index(i)] = propertiesOf(settings, grains.material[i]).isHeld ? 0 : 1;
    }
    ArrayXd sums = ArrayXd::Zero(capacity_.size() + nGhosts_);
    for (const ContactConductance& contact : contacts_)
    {
        sums[Index(contact.a)] += contact.conductance;
        sums[Index(contact.b)] += contact.conductance;
    }
    conductance_ = ofOwners(sums);
}


ArrayXd ContactConduction::withGhosts(const ArrayXd& own) const
{
    std::vector<double> shared, ghosts;
    for (const int i : shared_) shared.push_back(own[i]);
    exchange_.toGhosts(shared, ghosts, 1);
    ArrayXd all(own.size() + nGhosts_);
    all << own, Eigen::Map<const ArrayXd>(ghosts.data(), nGhosts_);
    return all;
}


/// Sums of what own grains have here and as ghosts elsewhere.
ArrayXd ContactConduction::ofOwners(const ArrayXd& withGhosts) const
{
    ArrayXd own = withGhosts.head(capacity_.size());
    const std::vector<double> ghosts(withGhosts.data() + own.size(), withGhosts.data() + withGhosts.size());
    std::vector<double> shared;
    exchange_.toOwners(ghosts, shared, 1);
    for (std::size_t k = 0; k < shared_.size(); ++k) own[shared_[k]] += shared[k];
    return own;
}


/// Heat to each own grain at these temperatures [W].
ArrayXd ContactConduction::flow(const ArrayXd& temperature) const
{
    const ArrayXd all = withGhosts(temperature);
    ArrayXd heat = ArrayXd::Zero(all.size());
    for (const ContactConductance& contact : contacts_)
    {
        const scalar toA = contact.conductance*(all[Index(contact.b)] - all[Index(contact.a)]);
        heat[Index(contact.a)] += toA;
        heat[Index(contact.b)] -= toA;
    }
    return ofOwners(heat);
}


// A held grain's equation is left out: no step, and no direction, has a part of it.
ConductedHeat ContactConduction::over(const std::vector<scalar>& temperature, scalar deltaT) const
{
    const ArrayXd start = Eigen::Map<const ArrayXd>(temperature.data(), capacity_.size());
    const ArrayXd inverseDiagonal = isFree_/(capacity_ + deltaT*conductance_);
    ArrayXd change = ArrayXd::Zero(start.size()), left = deltaT*flow(start), step = inverseDiagonal*left, direction = step;
    Residual residual = residualOf(left, step, exchange_);
    const scalar accepted = roundOff*largestSize(start, exchange_);
    for (int k = 0; residual.largest > accepted && k < maxIterations; ++k)
    {
        const ArrayXd taken = capacity_*direction - deltaT*flow(direction);
        const scalar share = residual.energy/sumOverRanks((direction*taken).sum(), exchange_);
        change += share*direction;
        left -= share*taken;
        step = inverseDiagonal*left;
        const Residual next = residualOf(left, step, exchange_);
        direction = step + next.energy/residual.energy*direction;
        residual = next;
    }
    const ArrayXd heat = deltaT*flow(start + change);
    // Heats give left/(m c) more than `change`, which is off by no more than the largest such by the maximum principle.
    const scalar off = residual.largest > accepted ? 2*largestSize(isFree_*left/capacity_, exchange_) : 0;
    return {std::vector<scalar>(heat.begin(), heat.end()), off};
}

} // namespace nscdCoupling
} // namespace Foam
