// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Texts that every front end refuses: keywords, materials, sources, settings. Walls and what moves are in wrongMotions.hpp.
#pragma once

#include "unit/input/frontEnds.hpp"

namespace frontEnds
{

inline std::vector<Wrong> wrongInputs()
{
    return
    {
        // Keywords
        {"misspeltTopKeyword", "maxInitialOverlap", "maxInitalOverlap", 9, {"keyword maxInitalOverlap is not a keyword here", "nearest: maxInitialOverlap"}},
        {"misspeltMaterials", "materials ", "materialsx ", 1, {"keyword materialsx", "materials is missing", "nearest: materials"}},
        {"misspeltContacts", "contacts ", "contactsx ", 2, {"keyword contactsx", "contacts is missing", "nearest: contacts"}},
        {"misspeltGrains", "grains ", "grainsx ", 3, {"keyword grainsx", "grains is missing", "nearest: grains"}},
        {"misspeltFriction", "friction 0.3", "frction 0.3", 2, {"keyword contacts.default.frction", "friction is missing", "nearest: friction"}},
        {"misspeltDensity", "density 2500", "densty 2500", 1, {"keyword materials.glass.densty is not a keyword here", "nearest: density"}},
        {"misspeltKeywordInside", "jitter 0.5", "jiter 0.5", 3, {"keyword grains.jiter is not a keyword here", "value:   jiter", "nearest: jitter"}},
        {"misspeltSetting", "type NLGS;", "tolerence 1;", 7, {"keyword solver.tolerence is not a keyword here", "maxSweeps", "nearest: tolerance"}},
        {"keywordOfAnotherPlace", "type NLGS;", "type NLGS; friction 1;", 7, {"keyword solver.friction is not a keyword here"}},
        {"keywordOfASpecialSource", "spread 0.2;", "spread 0.2; file x;", 3, {"keyword grains.file is not a keyword here"}},
        {"missingKeyword", "diameter 0.01; ", "", 3, {"keyword grains.diameter is missing", "allowed: diameter value;"}},
        {"missingDictionary", "contacts  { default { friction 0.3; restitution 0.2; } }", "", 0, {"keyword contacts is missing"}},
        {"dictionaryForValue", "maxInitialOverlap 0.01;", "maxInitialOverlap { a 1; }", 9, {"keyword maxInitialOverlap is a dictionary where a value belongs"}},
        {"valueForDictionary", "solver    { type NLGS; }", "solver NLGS;", 7, {"keyword solver is not a dictionary", "value:   NLGS"}},
        {"valueForMaterial", "glass { density 2500; }", "glass 2500;", 1, {"keyword materials.glass is not a dictionary", "value:   2500"}},
        {"missingSemicolon", "diameter 0.01;", "diameter 0.01", 3, {"keyword grains.diameter is not a single number (a missing semicolon?)"}},
        {"missingSemicolonBeforeADictionary", "wallMaterial steel;", "wallMaterial steel", 4, {"keyword wallMaterial has no semicolon before {"}},
        {"keywordTwice", "diameter 0.01;", "diameter 0.01; diameter 0.02;", 3, {"keyword grains.diameter is given twice, first in line 3"}},
        {"dictionaryTwice", "driven    { }", "driven { } solver { tolerance 1; }", 8, {"keyword solver is given twice, first in line 7"}},

        // Numbers
        {"wordForNumber", "diameter 0.01", "diameter small", 3, {"keyword grains.diameter is not a finite number", "value:   small"}},
        {"unitBehindNumber", "diameter 0.01", "diameter 10mm", 3, {"keyword grains.diameter is not a", "value:   10"}},
        {"notANumber", "diameter 0.01", "diameter nan", 3, {"keyword grains.diameter is not a finite number", "value:   nan"}},
        {"infiniteNumber", "diameter 0.01", "diameter inf", 3, {"keyword grains.diameter is not a finite number", "value:   inf"}},
        {"overflowingNumber", "diameter 0.01", "diameter 1e999", 3, {"keyword grains.diameter is not a finite number", "value:   1e999"}},
        {"hugeNumber", "diameter 0.01", "diameter 1e300", 3, {"keyword grains.diameter is too large", "allowed: numbers up to 1e+30"}},
        {"hugeComponent", "box (0 0 0)", "box (-1e300 0 0)", 3, {"keyword grains.box is too large", "allowed: numbers up to 1e+30"}},
        {"tinyNumber", "diameter 0.01", "diameter 1e-200", 3, {"keyword grains.diameter is too small", "allowed: numbers from 1e-30 on"}},
        {"hexadecimalNumber", "diameter 0.01", "diameter 0x10", 3, {"keyword grains.diameter is not a"}},
        {"quotedNumber", "diameter 0.01", "diameter \"0.01\"", 3, {"keyword grains.diameter is not a finite number"}},
        {"twoNumbers", "diameter 0.01;", "diameter 0.01 0.02;", 3, {"keyword grains.diameter is not a single number", "value:   0.01 0.02"}},
        {"wrongDimensions", "density 2500", "density [0 1 0 0 0 0 0] 2500", 1, {"keyword materials.glass.density has wrong dimensions", "[1 -3 0 0 0 0 0]"}},
        {"dimensionsOfTime", "diameter 0.01", "diameter d [0 0 1 0 0 0 0] 0.01", 3, {"keyword grains.diameter has wrong dimensions", "[0 1 0 0 0 0 0]"}},
        {"dimensionsAlone", "density 2500", "density [1 -3 0 0 0 0 0]", 1, {"keyword materials.glass.density has no value"}},
        {"openDimensions", "density 2500", "density [1 -3 0 0 0 2500", 1, {"keyword materials.glass.density has dimensions without a closing ]"}},
        {"shortVector", "spread 0.2;", "spread 0.2; velocity (0 1);", 3, {"keyword grains.velocity is not a vector", "value:   ( 0 1 )"}},
        {"numberForVector", "spread 0.2;", "spread 0.2; velocity 3;", 3, {"keyword grains.velocity is not a vector", "value:   3"}},
        {"vectorWithAWord", "spread 0.2;", "spread 0.2; velocity (0 0 down);", 3, {"keyword grains.velocity is not a finite number"}},

        // Settings
        {"unknownSolver", "type NLGS", "type NGLS", 7, {"keyword solver.type is not one of the words allowed", "value:   NGLS", "queue", "nearest: NLGS"}},
        {"negativeTolerance", "type NLGS;", "type NLGS; tolerance -1;", 7, {"keyword solver.tolerance is out of range", "value:   -1", "> 0"}},
        {"negativeSkin", "type NLGS;", "skin -1;", 7, {"keyword solver.skin is out of range", ">= 0"}},
        {"zeroSweeps", "type NLGS;", "type NLGS; maxSweeps 0;", 7, {"keyword solver.maxSweeps is out of range", ">= 1"}},
        {"halfASweep", "type NLGS;", "maxSweeps 2.5;", 7, {"keyword solver.maxSweeps is not a whole number", "value:   2.5"}},
        {"switchThatIsNone", "type NLGS;", "type NLGS; accelerate maybe;", 7, {"keyword solver.accelerate is not one of the words allowed"}},
        {"unknownVectorPath", "type NLGS;", "type NLGS; vectorPath AVX;", 7, {"keyword solver.vectorPath", "allowed: auto, portable, AVX2, AVX512"}},
        {"negativeOverlap", "maxInitialOverlap 0.01", "maxInitialOverlap -0.01", 9, {"keyword maxInitialOverlap is out of range", ">= 0"}},

        // Materials
        {"unknownWallMaterial", "wallMaterial steel", "wallMaterial stel", 4, {"keyword wallMaterial", "value:   stel", "nearest: steel"}},
        {"misspeltWallMaterial", "wallMaterial steel", "wallMateral steel", 4, {"keyword wallMateral is not a keyword here", "nearest: wallMaterial"}},
        {"noMaterialOfWalls", "wallMaterial steel;", "", 5, {"keyword walls.tray.material is missing", "wallMaterial ...; for all walls: glass, steel"}},
        {"negativeDensity", "density 2500", "density -2500", 1, {"keyword materials.glass.density is out of range", "value:   -2500", "> 0"}},
        {"zeroDensity", "density 2500", "density 0", 1, {"keyword materials.glass.density is out of range", "> 0"}},
        {"densityOfTwoNumbers", "density 2500", "density 1 2", 1, {"keyword materials.glass.density is not a single number", "value:   1 2"}},
        {"grainsWithoutDensity", "type lattice;", "type lattice; material steel;", 1, {"keyword materials.steel has no density"}},
        {"grainsOfUnknownMaterial", "type lattice;", "type lattice; material glas;", 3, {"keyword grains.material", "nearest: glass"}},
        {"negativeFriction", "friction 0.3", "friction -0.3", 2, {"keyword contacts.default.friction is out of range", "value:   -0.3", ">= 0"}},
        {"noFriction", "friction 0.3; ", "", 2, {"keyword contacts.default.friction is missing"}},
        {"restitutionAboveOne", "restitution 0.2", "restitution 1.2", 2, {"keyword contacts.default.restitution is out of range", ">= 0 and <= 1"}},
        {"negativeRollingFriction", "restitution 0.2", "rollingFriction -0.1", 2, {"keyword contacts.default.rollingFriction is out of range", ">= 0"}},
        {"misspeltRollingFriction", "restitution 0.2", "rolingFriction 0.1", 2, {"keyword contacts.default.rolingFriction", "nearest: rollingFriction"}},
        {"cohesionInMeters", "restitution 0.2", "cohesion [0 1 0 0 0 0 0] 1", 2, {"keyword contacts.default.cohesion has wrong dimensions", "[1 1 -2 0 0 0 0]"}},
        {"rangeOfNoFilm", "restitution 0.2", "lubricationRange 1e-4", 2, {"keyword contacts.default.roughness is missing", "1e-6"}},
        {"filmOfNoRange", "restitution 0.2", "roughness 1e-6", 2, {"keyword contacts.default.lubricationRange is missing"}},
        {"filmBesideRolling", "restitution 0.2", "roughness 1e-6; lubricationRange 1e-4; lubricationViscosity 1e-3; rollingFriction 0.1", 2,
            {"keyword contacts has a roughness beside rolling or spinning friction"}},
        {"pairOfUnknownMaterial", "contacts  { ", "contacts  { glass-stel { friction 1; } ", 2, {"keyword contacts.glass-stel is not a keyword here", "nearest: glass-steel"}},
        {"pairInBothOrders", "contacts  { ", "contacts  { glass-steel { friction 1; } steel-glass { friction 1; } ", 2, {"keyword contacts.steel-glass repeats a pair"}},
        {"pairThatIsMissing", "default {", "glass-glass {", 2, {"keyword contacts lacks the pair glass-steel, which can meet", "default"}},

        // Sources
        {"sourceOfUnknownType", "type lattice", "type latice", 3, {"keyword grains.type", "value:   latice", "positionsFile", "nearest: lattice"}},
        {"misspeltType", "type lattice", "typ lattice", 3, {"keyword grains.typ is not a keyword here", "nearest: type"}},
        {"grainsWithoutType", "type lattice; ", "", 3, {"stands in grains without a type"}},
        {"negativeDiameter", "diameter 0.01", "diameter -0.01", 3, {"keyword grains.diameter is out of range", "value:   -0.01", "> 0"}},
        {"emptyLattice", "box (0 0 0) (0.06", "box (0.1 0 0) (0.06", 3, {"keyword grains.box is empty"}},
        {"oneCorner", "box (0 0 0) (0.06 0.06 0.08)", "box (0 0 0)", 3, {"keyword grains.box does not hold two vectors"}},
        {"halfAGrain", "count (5 5 5)", "count (5 5 2.5)", 3, {"keyword grains.count is not three whole numbers"}},
        {"countOfWords", "count (5 5 5)", "count (a b c)", 3, {"keyword grains.count is not a finite number"}},
        {"noCount", "count (5 5 5); ", "", 3, {"keyword grains.count is missing", "spacing"}},
        {"countAndSpacing", "count (5 5 5);", "count (5 5 5); spacing 0.02;", 3, {"keyword grains.spacing stands beside count"}},
        {"tooManyGrains", "count (5 5 5)", "count (50000 50000 50000)", 3, {"keyword grains.count makes too many grains", "value:   ( 50000 50000 50000 )"}},
        {"moreGrainsThanMemory", "count (5 5 5)", "count (999 1000 1000)", 3, {"keyword grains.count makes too many grains", "memory of this machine"}},
        {"tooFineASpacing", "count (5 5 5)", "spacing 1e-9", 3, {"keyword grains.spacing makes too many grains"}},
        {"spreadOfOne", "spread 0.2", "spread 1", 3, {"keyword grains.spread is out of range", "< 1"}},
        {"halfASeed", "spread 0.2", "seed 0.5", 3, {"keyword grains.seed is not a whole number"}},
        {"heldOrNot", "spread 0.2", "motion fixd", 3, {"keyword grains.motion", "nearest: fixed"}},
        {"numberForFile", "lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;", "table; file 3;", 3,
            {"keyword grains.file is not a word or a quoted string"}},
        {"tableWithoutFile", "lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;", "table;", 3,
            {"keyword grains.file is missing"}},
        {"positionsWithoutDiameter", "lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
            "positionsFile; file x;", 3, {"keyword grains.diameter is missing"}},
        {"fillingWithoutAmount", "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
            "type filling; region { type box; box (0 0 0) (0.06 0.06 0.08); } diameter 0.01;", 3, {"keyword grains.number is missing", "solidFraction 0.3;"}},
        {"fillingTooDense", "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
            "type filling; region { type box; box (0 0 0) (0.06 0.06 0.08); } packing { solidFraction 0.65; } diameter 0.01;", 3,
            {"keyword grains.packing.solidFraction is out of range", "value:   0.65"}},
        {"fillingWithoutRoom", "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
            "type filling; region { type box; box (0 0 0) (0.06 0.06 0.08); } number 200; diameter 0.01;", 3,
            {"keyword grains.number asks for 200 grains", "found places for", "packing { solidFraction 0.6; }"}},
        {"missingFile", "lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;", "table; file grain.txt;", 3,
            {"keyword grains.file names a file that does not exist", "grain.txt", "nearest: grains.txt"}},
        {"overlappingGrains", "diameter 0.01", "diameter 0.03", 9, {"keyword maxInitialOverlap is exceeded by", "overlap by"}},
        {"grainsBehindAWall", "walls     { tray { type box; box (0 0 0)", "walls     { tray { type box; box (0.03 0 0)", 9, {"and the wall tray overlap"}},
        {"velocityOutOfPlane", "spread 0.2;", "velocity (0 0 1);", 3, {"keyword grains.velocity leaves the plane of the grains", "(x y 0)"}, Space::discs},
        {"spinOutOfPlane", "spread 0.2;", "omega (1 0 0);", 3, {"keyword grains.omega turns out of the plane of the grains", "(0 0 z)"}, Space::discs}
    };
}

/// With a sphere at (0.03 0.03 0.03) beside each wrong line.
inline std::vector<WrongFile> wrongFiles()
{
    const std::string huge = "1e300";
    return
    {
        {"emptyList", false, "", 1, {"is cut short"}},
        {"word", false, "x", 1, {"does not begin with a list", "value:   x"}},
        {"twoCoordinates", false, "(\n(0.03 0.03 0.03)\n(0.01 0.01)\n)", 3, {"not a finite number", "( (x y z)"}},
        {"nanCoordinate", false, "(\n(0.03 0.03 0.03)\n(0.01 nan 0.01)\n)", 3, {"not a finite number", "value:   nan"}},
        {"overflowingCoordinate", false, "(\n(0.03 0.03 0.03)\n(0.01 1e999 0.01)\n)", 3, {"not a finite number", "value:   1e999"}},
        {"hugeCoordinate", false, "(\n(0.03 0.03 0.03)\n(0.01 " + huge + " 0.01)\n)", 3, {"not a finite number", "up to 1e30"}},
        {"fourCoordinates", false, "(\n(0.03 0.03 0.03 0.03)\n)", 2, {"without three coordinates"}},
        {"cutInAPosition", false, "(\n(0.03 0.03 0.03)\n(0.01 0.01", 3, {"is cut short"}},
        {"cutInTheList", false, "(\n(0.03 0.03 0.03)\n", 3, {"is cut short"}},
        {"numberForPosition", false, "(\n(0.03 0.03 0.03)\n5\n)", 3, {"no position", "value:   5"}},
        {"wrongNumber", false, "3 ( (0.03 0.03 0.03) (0.01 0.01 0.01) )\n", 2, {"states 3 positions and holds 2"}},
        {"secondList", false, "( (0.03 0.03 0.03) ) ( (0.01 0.01 0.01) )", 1, {"goes on after its list"}},
        {"listOfNothing", false, "()", 0, {"keyword grains.file names a file that holds no grain"}},
        {"openComment", false, "/* (1 2 3)", 1, {"cut short"}},
        {"zeroInAList", false, std::string("((0.03 0.03 0.03)\n\0)", 20), 2, {"holds a character that is no text"}},
        {"zeroInARow", true, std::string("0.03 0.03 0.03 0.01\0x", 21), 1, {"holds a character that is no text"}},
        {"shortRow", true, "0.03 0.03 0.03 0.01\n1 2 3\n", 2, {"without four finite numbers", "value:   1 2 3", "x y z d"}},
        {"infiniteRow", true, "1 2 3 inf\n", 1, {"without four finite numbers"}},
        {"overflowingRow", true, "0.03 0.03 0.03 0.01\n1e999 2 3 1\n", 2, {"without four finite numbers"}},
        {"hugeRow", true, "1 2 3 " + huge + "\n", 1, {"without four finite numbers", "up to 1e30"}},
        {"letterInANumber", true, "1 2 3x 4\n", 1, {"without four finite numbers"}},
        {"hexadecimalRow", true, "1 2 0x3 4\n", 1, {"without four finite numbers"}},
        {"negativeDiameterInARow", true, "1 2 3 -4\n", 1, {"diameter that is not positive"}},
        {"sixColumns", true, "1 2 3 4 glass 5\n", 1, {"more than five columns"}},
        {"noRow", true, "# nothing\n", 0, {"keyword grains.file names a file that holds no grain"}},
        {"unknownMaterialInARow", true, "0.03 0.03 0.03 0.01\n0.01 0.01 0.01 0.01 glas\n", 2, {"unknown or has no density", "value:   glas", "nearest: glass"}},
        {"materialOfWallsInARow", true, "0.03 0.03 0.03 0.01 steel\n", 1, {"unknown or has no density", "value:   steel"}}
    };
}

} // namespace frontEnds
