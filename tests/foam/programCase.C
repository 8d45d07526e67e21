// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing the whole case and running programs on it.
#include "programCase.H"

#include "caseTools.H"

#include "OSspecific.H"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace Foam
{
namespace nscdCoupling
{
namespace testing
{

namespace
{

Files defaultFiles()
{
    return
    {
        {"constant/grainProperties",
            "materials { glass { density 2500; } }\n"
            "contacts { default { friction 0.3; } }\n"
            "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; }\n"
            "patches { front { type wall; } back { type exit; } }\n"},
        {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);"},
        {"constant/transportProperties", "transportModel Newtonian; nu 1e-4; rho 1000;"},
        {"constant/turbulenceProperties", "simulationType laminar;"},
        {"0/U",
            "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { "
            "\"(left|right|bottom|top)\" { type noSlip; } front { type fixedValue; value uniform (0 0 0); } "
            "back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }"},
        {"0/p_rgh",
            "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { "
            "\"(left|right|bottom|top|front)\" { type fixedFluxPressure; value uniform 0; } "
            "back { type fixedValue; value uniform 0; } }"},
        {"system/fvSchemes",
            "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }"
            "divSchemes { default Gauss linear; div(phi,U) Gauss upwind; }"
            "laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }"
            "snGradSchemes { default corrected; }"},
        {"system/fvSolution", solutionWith(2)}
    };
}

} // namespace

std::string solutionWith(int correctors)
{
    return "solvers { \"p_rgh.*\" { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; }"
        "\"U.*\" { solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 0; } }"
        "PIMPLE { nCorrectors " + std::to_string(correctors) + "; }";
}

BoxMeshSettings programBox()
{
    BoxMeshSettings settings;
    settings.cells = labelVector(4, 4, 8);
    settings.max = point(0.1, 0.1, 0.2);
    settings.patchTypes = {"wall", "wall", "wall", "wall", "patch", "patch"};
    return settings;
}

ProgramCase::ProgramCase(const Files& files, const std::string& control, const BoxMeshSettings& box)
:
    box_(box)
{
    Files all = defaultFiles();
    for (const auto& file : files) all[file.first] = file.second;
    for (const auto& file : all)
    {
        if (file.second.empty()) rm(path(file.first));
        else write(file.first, file.second);
    }
    writeControl(control);
    box_.mesh().setInstance("constant");
    box_.mesh().write();
}

void ProgramCase::writeControl(const std::string& more) const
{
    write
    (
        "system/controlDict",
        "application nscdDEMFoam; startFrom latestTime; startTime 0; stopAt endTime; endTime 0.01; deltaT 1e-3;"
        "writeControl timeStep; writeInterval 10; writeFormat ascii; writePrecision 12; timePrecision 10; " + more
    );
}

ProgramRun ProgramCase::execute(const std::string& command, const std::string& name) const
{
    const fileName log = path("log." + name);
    // Where a part has no fields, decomposePar puts its link to `uniform` into the current folder.
    const int status = std::system(("cd " + box_.casePath() + " && " + command + " > " + log + " 2>&1 < /dev/null").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents("log." + name)};
}

ProgramRun ProgramCase::run(const std::string& program, const std::string& arguments) const
{
    const fileName own = fileName(Foam::getEnv("FOAM_USER_APPBIN"))/program;
    return execute((isFile(own) ? std::string(own) : program) + " -case " + box_.casePath() + " " + arguments, program);
}

ProgramRun ProgramCase::decompose(const labelVector& parts, const std::string& arguments) const
{
    std::ostringstream text;
    text << "numberOfSubdomains " << cmptProduct(parts) << "; method simple; simpleCoeffs { delta 0.001; n ("
        << parts.x() << ' ' << parts.y() << ' ' << parts.z() << "); }";
    write("system/decomposeParDict", text.str());
    return run("decomposePar", arguments);
}

ProgramRun ProgramCase::runOn(label ranks, const std::string& arguments) const
{
    if (std::string(::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name()) != "Ranks")
    {
        ADD_FAILURE() << "tests that start several ranks belong in the suite Ranks: beside others they take twenty times as long";
    }
    // More ranks than cores is fine here; in a container without users, everybody is root.
    std::ostringstream command;
    command << "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 200 mpirun --oversubscribe"
        << " --mca mpi_yield_when_idle 1 -np " << ranks << " " << std::string(Foam::getEnv("FOAM_USER_APPBIN"))
        << "/nscdDEMFoam -case " << box_.casePath() << " " << arguments;
    return execute(command.str(), "ranks");
}

void ProgramCase::goOnOnFourOneAndTwo(const std::string& one, const std::string& two) const
{
    EXPECT_TRUE(succeeds(decompose(labelVector(2, 2, 1))));
    EXPECT_TRUE(succeeds(runOn(4)));
    EXPECT_TRUE(succeeds(run("reconstructPar", "-latestTime")));
    writeControl(one);
    EXPECT_TRUE(succeeds(run()));
    // Where the upper half of the mesh holds no grain, it gets no file of them.
    EXPECT_TRUE(succeeds(decompose(labelVector(1, 1, 2))));
    writeControl(two);
    EXPECT_TRUE(succeeds(runOn(2)));
}

std::string ProgramCase::contents(const fileName& file) const
{
    std::ifstream is(path(file));
    return std::string((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
}

std::string ProgramCase::latestTime(const fileName& folder) const
{
    return Time::findTimes(path(folder)).last().name();
}

std::vector<double> ProgramCase::reported(const std::string& startTime, const std::string& column) const
{
    std::istringstream is(contents("postProcessing/grains/" + startTime + "/report.csv"));
    std::vector<double> values;
    long wanted = -1;
    for (std::string line; std::getline(is, line);)
    {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> cells;
        std::istringstream cellsOfLine(line);
        for (std::string cell; std::getline(cellsOfLine, cell, ',');) cells.push_back(cell);
        if (wanted < 0) wanted = std::find(cells.begin(), cells.end(), column) - cells.begin();
        else values.push_back(std::stod(cells.at(wanted)));
    }
    return values;
}

Files dryFiles(const std::string& grainProperties)
{
    Files files{{"constant/grainProperties", grainProperties}};
    for (const char* file : {"constant/transportProperties", "constant/turbulenceProperties", "0/U", "0/p_rgh"}) files[file] = "";
    return files;
}

double largest(const std::vector<double>& values)
{
    double most = values.empty() ? GREAT : 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

::testing::AssertionResult succeeds(const ProgramRun& run)
{
    return run.status == 0 ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << run.status << ": " << run.log;
}

::testing::AssertionResult isRefused(const ProgramCase& c, const std::vector<std::string>& pieces, const std::string& arguments)
{
    const ProgramRun run = c.run("nscdDEMFoam", arguments);
    if (run.status != 1) return ::testing::AssertionFailure() << "status " << run.status << ": " << run.log;
    if (!c.reported("0", "time").empty()) return ::testing::AssertionFailure() << "a step was taken: " << run.log;
    return holds(run.log, pieces);
}

} // namespace testing
} // namespace nscdCoupling
} // namespace Foam
