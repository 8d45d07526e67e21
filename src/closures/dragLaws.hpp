// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws by name: each gives the coefficient gamma of the force gamma (u - v) of the fluid on one grain. The laws are in closures/drag.
#pragma once

#include "closures/drag/dragState.hpp"

#include <functional>
#include <string>
#include <vector>

namespace closures
{

GrainSize sphereSize(double diameter);
/// A disc is a cylinder across the flow, of length `thickness` along the empty direction of a 2D case.
GrainSize discSize(double diameter, double thickness);

/// Coefficient C [N m s] of the viscous torque C (curl u/2 - omega) on a grain alone at small Reynolds number.
/// Equation: pi mu d^3 for a sphere (Kirchhoff 1876; Lamb 1932, art. 334)
double sphereSpinDrag(double diameter, double viscosity);
/// Equation: pi mu d^2 t for a disc, which is a cylinder of length t (Lamb 1932, art. 333)
double discSpinDrag(double diameter, double thickness, double viscosity);

/// Drag coefficient gamma [kg/s]: the fluid pulls the grain with gamma (u - v), in form A (the pressure force is apart).
/// Ensures: finite for slip >= 0, and gamma times slip grows with slip
using DragLaw = std::function<double(const DragState&)>;

/// Where a law is meant to be used: Re_s of the superficial slip up to highestRe, alpha within the two bounds.
struct DragRange
{
    double highestRe;
    double lowestFraction;
    double highestFraction;
};

/// How far a state is out of a law's range.
struct BeyondRange
{
    double Re;             ///< Re_s over the highest [-]; up to 1: within
    double fluidFraction;  ///< distance from the nearer bound of alpha [-]; 0: within
};

BeyondRange beyondRange(const DragRange& range, const DragState& state);

/// One row of the table of drag laws: what it is called, and what its shared tests may ask of it.
struct DragLawRow
{
    const char* name;
    const char* alias;   ///< second name, or empty
    double (*law)(const DragState&);
    double stokesLimit;  ///< gamma/(3 pi mu d) of a lone sphere (alpha = 1) at slip 0
    double slipJump;     ///< largest relative jump of gamma over slip; 0 if continuous
    double alphaJump;    ///< largest relative jump of gamma over alpha; 0 if continuous
    DragRange range;
    const char* source;  ///< the paper
};

/// All drag laws, in the order of the table.
const std::vector<DragLawRow>& dragLaws();

/// Names (without aliases) of all drag laws, for messages.
std::vector<std::string> dragLawNames();

/// The row of this name or alias.
/// Errors: std::invalid_argument, listing the names, for a word that is neither
const DragLawRow& findDragLaw(const std::string& name);

} // namespace closures
