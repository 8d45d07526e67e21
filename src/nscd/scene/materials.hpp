// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Materials of grains and walls, and the contact coefficients of every pair of them.
#pragma once

#include <string>
#include <vector>

namespace nscd
{

/// The contact laws of one pair of materials.
struct ContactPair
{
    double friction = 0.0;          ///< Coulomb's mu, >= 0
    double restitution = 0.0;       ///< Newton's e in [0, 1]; 0 is the inelastic shock
    double rollingFriction = 0.0;   ///< mu_r >= 0: see rollingFriction.hpp
    double spinningFriction = 0.0;  ///< mu_s >= 0: likewise
    double cohesion = 0.0;          ///< attraction of a closed contact, the force that pulls it off, >= 0 [N]
    double cohesionRange = 0.0;     ///< gap up to which it acts on open contacts too, >= 0 [m]
    double roughness = 0.0;         ///< thickness of the film of fluid that is left where surfaces touch, >= 0 [m]; 0: no film, see lubrication.hpp
    double lubricationRange = 0.0;  ///< gap up to which a film acts, > 0 where there is one [m]
    double lubricationViscosity = 0.0;  ///< dynamic viscosity of the film's fluid, >= 0 [Pa s]; 0: no film
};

/// Named materials with a symmetric table of pairs; a pair nobody set is frictionless, inelastic, and does not cohere.
class Materials
{
public:
    /// Adds a material and returns its index.
    /// Errors: std::invalid_argument if the name exists
    int add(const std::string& name);

    /// Sets a pair (symmetric).
    /// Errors: std::invalid_argument for a negative or not finite coefficient, restitution outside [0, 1], or an unknown index
    void setPair(int materialA, int materialB, const ContactPair& pair);

    const ContactPair& pair(int materialA, int materialB) const { return pairs_[materialA*size() + materialB]; }
    bool isPairSet(int materialA, int materialB) const { return isSet_[materialA*size() + materialB] != 0; }

    int size() const { return static_cast<int>(names_.size()); }
    const std::vector<std::string>& names() const { return names_; }
    /// Index of a name, or -1.
    int find(const std::string& name) const;

    bool anyFriction() const;
    /// Of all pairs.
    double largestFriction() const;
    bool anyRestitution() const;
    /// Whether any pair resists rolling or spinning.
    bool anyRolling() const;
    bool anyCohesion() const;
    /// Largest range of any pair that coheres [m].
    double cohesionRange() const;
    /// Whether any pair has films of lubrication.
    bool anyRoughness() const;
    /// Whether any film has no viscosity yet.
    bool lacksFilmViscosity() const;
    /// Of films that have none yet [Pa s].
    void setFilmViscosity(double viscosity);
    /// Largest range of any pair with a film [m].
    double lubricationRange() const;

private:
    std::vector<std::string> names_;
    std::vector<ContactPair> pairs_;
    std::vector<char> isSet_;
};

} // namespace nscd
