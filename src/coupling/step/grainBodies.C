// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// From grains to bodies, and back.
#include "coupling/step/grainBodies.H"

#include "mathematicalConstants.H"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Radius of the sphere, or the disc, of a volume [m].
double equivalentRadius(double volume, const ::nscd::GrainShape& shape)
{
    const double pi = constant::mathematical::pi;
    return shape.dimensions == 2 ? std::sqrt(volume/(pi*shape.thickness)) : std::cbrt(volume/(4.0/3.0*pi));
}

template<class Type>
std::vector<Type> picked(const std::vector<Type>& from, const std::vector<std::size_t>& indices)
{
    std::vector<Type> to;
    to.reserve(indices.size());
    for (const std::size_t i : indices) to.push_back(from[i]);
    return to;
}

template<class Type>
std::vector<Type> spreadOver(const std::vector<Type>& ofBodies, const std::vector<label>& bodyOf)
{
    std::vector<Type> to;
    to.reserve(bodyOf.size());
    for (const label body : bodyOf) to.push_back(ofBodies[body]);
    return to;
}

/// Values of bodies at their first grains, zero elsewhere; none where there are none.
template<class Type>
std::vector<Type> atFirst(const std::vector<Type>& ofBodies, const std::vector<std::size_t>& firstOf, std::size_t grains, const Type& zero)
{
    if (ofBodies.empty()) return {};
    std::vector<Type> to(grains, zero);
    for (std::size_t body = 0; body < firstOf.size(); ++body) to[firstOf[body]] = ofBodies[body];
    return to;
}

template<class Change>
GrainExtras changed(const GrainExtras& extras, const Change& change)
{
    GrainExtras to;
    for (const auto& [name, values] : extras.scalars) to.scalars[name] = change(values);
    for (const auto& [name, values] : extras.vectors) to.vectors[name] = change(values);
    return to;
}

} // namespace

void GrainBodies::update(const ::nscd::Grains& grains)
{
    grains_ = &grains;
    if (grains.clumps.empty())
    {
        parts_ = MappedBodies();
        return;
    }
    forms_.clumps = &grains.clumps;
    if (forms_.ofShape.size() != grains.clumps.shapes.size()) measureForms(grains);
    listParts(grains);
    copyBodies(grains);
}

void GrainBodies::measureForms(const ::nscd::Grains& grains)
{
    forms_.ofShape.clear();
    for (const ::nscd::ClumpShape& shape : grains.clumps.shapes) forms_.ofShape.push_back(::nscd::formOf(shape, grains.shape));
}

void GrainBodies::listParts(const ::nscd::Grains& grains)
{
    const std::vector<int> clumpOf = ::nscd::clumpOfGrains(grains);
    parts_ = MappedBodies();
    forms_.clumpOf.clear();
    firstOf_.clear();
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const bool isNew = clumpOf[i] < 0 || grains.clumps.firstMember[clumpOf[i]] == int(i);
        if (isNew)
        {
            firstOf_.push_back(i);
            forms_.clumpOf.push_back(clumpOf[i]);
            const bool isClump = clumpOf[i] >= 0;
            parts_.volume.push_back(isClump ? forms_.ofShape[grains.clumps.shape[clumpOf[i]]].volume : grains.volume(i));
        }
        parts_.bodyOf.push_back(label(firstOf_.size()) - 1);
        parts_.share.push_back(clumpOf[i] < 0 ? 1 : grains.mass[i]/grains.clumps.shapeOf(clumpOf[i]).mass);
    }
}

void GrainBodies::copyBodies(const ::nscd::Grains& grains)
{
    const ::nscd::Clumps& clumps = grains.clumps;
    bodies_.shape = grains.shape;
    ::nscd::Grains::forEachMember([&](const char*, auto array) { bodies_.*array = picked(grains.*array, firstOf_); });
    bodies_.nOwned = bodies_.size();
    for (std::size_t body = 0; body < firstOf_.size(); ++body)
    {
        const int clump = forms_.clumpOf[body];
        if (clump < 0) continue;
        bodies_.position[body] = clumps.position[clump];
        bodies_.velocity[body] = clumps.velocity[clump];
        bodies_.radius[body] = equivalentRadius(parts_.volume[body], grains.shape);
        bodies_.mass[body] = clumps.shapeOf(clump).mass;
    }
}

::nscd::ExternalForces GrainBodies::onGrains(::nscd::ExternalForces external) const
{
    if (areGrains()) return external;
    const std::size_t grains = grains_->size();
    external.force = atFirst(external.force, firstOf_, grains, Vec3(Vec3::Zero()));
    external.torque = atFirst(external.torque, firstOf_, grains, Vec3(Vec3::Zero()));
    external.implicitDrag = atFirst(external.implicitDrag, firstOf_, grains, 0.0);
    external.implicitSpinDrag = atFirst(external.implicitSpinDrag, firstOf_, grains, 0.0);
    return external;
}

std::vector<Vec3> GrainBodies::sums(const std::vector<Vec3>& ofGrains) const
{
    if (areGrains()) return ofGrains;
    std::vector<Vec3> sum(firstOf_.size(), Vec3::Zero());
    for (std::size_t i = 0; i < ofGrains.size(); ++i) sum[parts_.bodyOf[i]] += ofGrains[i];
    return sum;
}

::nscd::Prediction GrainBodies::ofBodies(::nscd::Prediction prediction) const
{
    if (areGrains()) return prediction;
    prediction.velocity = picked(prediction.velocity, firstOf_);
    prediction.contactForce = sums(prediction.contactForce);
    return prediction;
}

GrainExtras GrainBodies::toGrains(GrainExtras ofBodies) const
{
    if (areGrains()) return ofBodies;
    return changed(ofBodies, [&](const auto& values) { return spreadOver(values, parts_.bodyOf); });
}

GrainExtras GrainBodies::ofFirstGrains(const GrainExtras& ofGrains) const
{
    if (areGrains()) return ofGrains;
    return changed(ofGrains, [&](const auto& values) { return picked(values, firstOf_); });
}

std::vector<std::size_t> GrainBodies::bodiesOf(const std::vector<std::size_t>& grains) const
{
    if (areGrains()) return grains;
    std::vector<std::size_t> bodies;
    for (const std::size_t i : grains)
    {
        const std::size_t body = parts_.bodyOf[i];
        if (bodies.empty() || bodies.back() != body) bodies.push_back(body);
    }
    return bodies;
}

} // namespace nscdCoupling
} // namespace Foam
