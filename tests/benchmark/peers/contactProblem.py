# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A frozen contact problem of spheres from the files of `peers frozen`, its Delassus operator, and the residual every solution is judged by."""

import numpy


class ContactProblem:
    """Symbols as in src/nscd/method.md; world frame, SI units. Contacts have their impulses r as our solver left them."""

    def __init__(self, path):
        bodies = numpy.fromfile(str(path) + ".bodies").reshape(-1, 8)
        contacts = numpy.fromfile(str(path) + ".contacts").reshape(-1, 10)
        # One more body without mobility stands for walls.
        bodies = numpy.vstack([bodies, numpy.zeros(8)])
        self.v, self.mobility, self.s, self.spin = bodies[:, 0:3], bodies[:, 3], bodies[:, 4:7], bodies[:, 7]
        self.a = contacts[:, 0].astype(int)
        self.b = numpy.where(contacts[:, 1] < 0, len(bodies) - 1, contacts[:, 1]).astype(int)
        self.n, self.bias, self.friction, self.r = contacts[:, 2:5], contacts[:, 5], contacts[:, 6], contacts[:, 7:10]
        self.wn = self.mobility[self.a] + self.mobility[self.b]
        self.wt = self.wn + self.spin[self.a] + self.spin[self.b]

    def velocity(self, r):
        """Relative velocity of A to B at each contact under impulses r: free velocities plus W r."""
        v, s = self.v.copy(), self.s.copy()
        turn = numpy.cross(self.n, r)
        for body, sign in ((self.a, 1.0), (self.b, -1.0)):
            numpy.add.at(v, body, sign*self.mobility[body][:, None]*r)
            numpy.add.at(s, body, -self.spin[body][:, None]*turn)
        return v[self.a] - v[self.b] - numpy.cross(s[self.a] + s[self.b], self.n)

    def residual(self, r):
        """Natural map in velocity units: rms over contacts that carry an impulse or should, and the largest [m/s]."""
        u = self.velocity(r)
        un, rn = (u*self.n).sum(1), (r*self.n).sum(1)
        rt = r - rn[:, None]*self.n
        normal = self.wn*abs(rn - numpy.maximum(0.0, rn - (un + self.bias)/self.wn))
        q = rt - (u - un[:, None]*self.n)/self.wt[:, None]
        size, limit = numpy.linalg.norm(q, axis=1), self.friction*numpy.maximum(0.0, rn)
        q *= (limit/numpy.maximum(size, 1e-300)).clip(max=1.0)[:, None]
        square = normal**2 + (self.wt*numpy.linalg.norm(rt - q, axis=1))**2
        isActive = (rn > 0) | (normal > 0)
        return numpy.sqrt(square[isActive].mean()), numpy.sqrt(square.max())

    def frames(self):
        """Rows n, t1, t2 of each contact."""
        other = numpy.eye(3)[abs(self.n).argmin(1)]
        t1 = numpy.cross(self.n, other)
        t1 /= numpy.linalg.norm(t1, axis=1)[:, None]
        return numpy.stack([self.n, t1, numpy.cross(self.n, t1)], axis=1)

    def near(self, bias):
        """Which contacts have at most this bias [m/s], or carry an impulse; all a solver needs to know of."""
        return numpy.flatnonzero((self.bias <= bias) | (self.r != 0.0).any(1))

    def delassus(self, chosen):
        """W of the chosen contacts in their frames (scipy, csr), q = free velocity plus bias, and the frames."""
        from scipy import sparse
        frames, count = self.frames()[chosen], len(chosen)
        n = self.n[chosen]
        # H maps (v, s) of a body to u: +-1 for v, and s -> -s x n for both bodies.
        cross = numpy.zeros((count, 3, 3))
        for i, j, k, sign in ((0, 1, 2, -1), (0, 2, 1, 1), (1, 0, 2, 1), (1, 2, 0, -1), (2, 0, 1, -1), (2, 1, 0, 1)):
            cross[:, i, j] = sign*n[:, k]
        turn = -numpy.einsum("cij,cjk->cik", frames, -cross)
        blocks, rows, columns = [], [], []
        for body, sign in ((self.a[chosen], 1.0), (self.b[chosen], -1.0)):
            for place, part, mobility in ((0, sign*frames, self.mobility), (1, turn, self.spin)):
                blocks.append(part*numpy.sqrt(mobility[body])[:, None, None])
                rows.append(numpy.arange(count))
                columns.append(2*body + place)
        row, column, block = numpy.concatenate(rows), numpy.concatenate(columns), numpy.concatenate(blocks)
        i, j = numpy.meshgrid(range(3), range(3), indexing="ij")
        h = sparse.csr_matrix((block.ravel(), ((3*row[:, None, None] + i).ravel(), (3*column[:, None, None] + j).ravel())),
                              shape=(3*count, 6*len(self.mobility)))
        free = self.velocity(numpy.zeros_like(self.r))[chosen]
        q = numpy.einsum("cij,cj->ci", frames, free)
        q[:, 0] += self.bias[chosen]
        return (h@h.T).tocsr(), q.ravel(), frames
