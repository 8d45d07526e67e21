// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Implementation of implicitDrag.hpp.
#include "closures/implicitDrag.hpp"

#include <cmath>
#include <stdexcept>

namespace closures
{

double backwardEuler(double k)
{
    return k;
}

double exponential(double k)
{
    if (k < 0.1)
    {
        // Series of k/(1 - exp(-k)) - 1 (Bernoulli numbers), where the closed form cancels; the next term is k^10/4.8e7.
        const double k2 = k*k;
        return k/2 + k2*(1.0/12 - k2*(1.0/720 - k2*(1.0/30240 - k2/1209600)));
    }
    const double lost = -std::expm1(-k);
    return (k - lost)/lost;
}

DragWeighting findDragWeighting(const std::string& name)
{
    if (name == "backwardEuler") return backwardEuler;
    if (name == "exponential") return exponential;
    throw std::invalid_argument("drag weighting '" + name + "' is not known; known are: backwardEuler, exponential");
}

DragSplit splitDrag(double gamma, double mass, double dt, DragWeighting weighting)
{
    const double implicit = weighting(gamma*dt/mass)*mass/dt;
    return {implicit, gamma - implicit};
}

Eigen::Vector3d velocityAfter
(
    const DragStep& step, const Eigen::Vector3d& velocity, double gamma, DragWeighting weighting
)
{
    const double k = gamma*step.dt/step.mass;
    return velocity + (step.dt/step.mass*step.force + k*(step.fluidVelocity - velocity))/(1 + weighting(k));
}

double gammaAtMidSlip
(
    const DragLaw& law, const DragState& state, const DragStep& step, const Eigen::Vector3d& velocity, DragWeighting weighting
)
{
    DragState at = state;
    at.slip = (step.fluidVelocity - velocity).norm();
    const Eigen::Vector3d predicted = velocityAfter(step, velocity, law(at), weighting);
    at.slip = (step.fluidVelocity - 0.5*(velocity + predicted)).norm();
    return law(at);
}

} // namespace closures
