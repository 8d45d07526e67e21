# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The frozen contact problem of a settled bed, from cold, by our solver and by Siconos' NSGS; judged by one residual."""

import csv
import subprocess
import time

import numpy

from contactProblem import ContactProblem

CHUNK = 1.1     # growth of the number of iterations between two looks at the residual
GRAVITY, DELTA_T = 9.81, 1e-3
# Of our stop rule: largest defect times dt in d, over the tolerance of the rms, as the defaults have it (3e-4 d and 1e-2).
DISPLACEMENT_SHARE = 3e-2


def ours(program, bed, out, tolerance, core, samples=3):
    """Processor seconds of a cold solve, mean of some, sweeps, and the problem with the last solution."""
    output = subprocess.run(["taskset", "-c", str(core), program, "frozen", bed, out, "samples=%d" % samples, "tolerance=%.9g" % tolerance,
                             "displacementTolerance=%.9g" % (DISPLACEMENT_SHARE*tolerance), "maxSweeps=20000"],
                            check=True, stdout=subprocess.PIPE, text=True).stdout
    rows = list(csv.DictReader(output.splitlines()))
    mean = lambda name: sum(float(row[name]) for row in rows)/len(rows)
    return mean("seconds"), mean("sweeps"), ContactProblem(out)


class Nsgs:
    """Siconos' NSGS on the contacts of a problem that can carry anything, in its own form: u = W r + q, local frames, sparse blocks."""

    def __init__(self, problem, local="NSN_GP", storage="blocks"):
        import siconos.numerics as sn
        self.sn, self.problem = sn, problem
        # A gap that 2 g dt does not close stays open: checked by the residual, which looks at all contacts.
        self.chosen = problem.near(2*GRAVITY*DELTA_T)
        W, q, self.frames = problem.delassus(self.chosen)
        self.size = len(q)
        self.matrix, self.friction = self._matrix(W, storage), self.problem.friction[self.chosen].copy()
        self.own = sn.FrictionContactProblem(3, self.matrix, q, self.friction)
        self.options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_NSGS)
        self.options.iparam[sn.SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION] = sn.SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_LIGHT
        self.options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-300
        sn.solver_options_update_internal(self.options, 0, getattr(sn, "SICONOS_FRICTION_3D_ONECONTACT_" + local))

    def _matrix(self, W, storage):
        if storage == "csc":
            return W.tocsc()
        self.blocks = self.sn.SBM_from_csparse(3, W.tocsc())[1]
        return self.sn.NM_new_SBM(*W.shape, self.blocks)

    def solve(self, iterations, start=None):
        """Processor seconds and the impulses in the local frames."""
        r = numpy.zeros(self.size) if start is None else start.copy()
        u = numpy.zeros(self.size)
        self.options.iparam[self.sn.SICONOS_IPARAM_MAX_ITER] = iterations
        begin = time.process_time()
        self.sn.fc3d_nsgs(self.own, r, u, self.options)
        return time.process_time() - begin, r

    def impulses(self, r):
        """Of all contacts, in the world frame."""
        result = numpy.zeros_like(self.problem.r)
        result[self.chosen] = numpy.einsum("cij,ci->cj", self.frames, r.reshape(-1, 3))
        return result

    def residual(self, r):
        return [value/(GRAVITY*DELTA_T) for value in self.problem.residual(self.impulses(r))]

    def iterationsTo(self, rms, most):
        """How many iterations bring the rms residual to a bar, found in chunks; None if `most` do not."""
        done, r = 0, None
        while done < most:
            more = max(10, int((CHUNK - 1)*done))
            r = self.solve(more, r)[1]
            done += more
            if self.residual(r)[0] <= rms:
                return done
        return None


def addRows(table, program, bed, out, tolerance, most, core):
    """Ours, then theirs to the tolerance asked for and to the residual that ours reached, which is lower; ours once more. Theirs is timed in
    one go, once it is known how many iterations that takes."""
    seconds, sweeps, problem = ours(program, bed, out, tolerance, core)
    reached = [value/(GRAVITY*DELTA_T) for value in problem.residual(problem.r)]
    theirs, solved = Nsgs(problem), []
    for bar, rms in (("tolerance", tolerance), ("reached", reached[0])):
        iterations = theirs.iterationsTo(rms, most)
        if iterations is None:
            print("Siconos does not meet %g in %d iterations" % (rms, most))
            continue
        cost, r = theirs.solve(iterations)
        solved.append((bar, cost, iterations, theirs.residual(r)))
    seconds = 0.5*(seconds + ours(program, bed, out, tolerance, core)[0])
    for bar, cost, iterations, residual in solved:
        table.add(tolerance, bar, seconds, sweeps, *reached, cost, iterations, *residual, cost/seconds)
