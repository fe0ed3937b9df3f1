// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>

#include "flow/hierarchy.hpp"
#include "flow/operator.hpp"

namespace porefines::flow {

struct SolveOptions {
  Real tolerance = 1e-6;  ///< of the residual norm, relative to `reference`
  Real reference = 0;     ///< norm that 1 stands for; 0: norm of the first residual
  int max_cycles = 200;
  int directions = 1;       ///< previous search directions kept at first
  int most_directions = 2;  ///< kept when cycles gain little: one more after each of those
  std::function<void(int cycle, Real residual)> progress;  ///< called on every rank
  std::function<bool()> interrupted;                       ///< asked on every rank, same answer
};

struct SolveReport {
  int cycles = 0;       ///< until the residual fell below the tolerance
  int flux_cycles = 0;  ///< further ones until the flux agreed from plane to plane
  Real residual = 0;    ///< relative, recomputed from the solution in double precision
  bool converged = false;
};

/// Solves K x = b by the generalised conjugate residual method, preconditioned by one multigrid
/// cycle in single precision.
///
///     z = cycle(r);  q = K z;  orthogonalise q (and z) against the previous ones;
///     alpha = (r, q)/(q, q);  x += alpha z;  r -= alpha q
///
/// The Stokes operator is indefinite, so (r, q) may vanish and the step with it (GCR breaks down).
/// After a step that gained little, the cycle is applied to the last q instead of r, as in
/// Orthodir: the search space grows all the same. Not for longer than directions are kept: what is left of r may lie
/// outside of what the last q leads to, and then r itself, without former directions, is a new beginning.
/// Each slow mode that a cycle leaves behind costs about one kept direction. Coarse grids that see the
/// throats (coarse_mobility) leave few, so most_directions is small.
/// x is double, all else float. Since rounding lets r drift from b - K x by about 1e-7, the true
/// residual is recomputed before convergence is claimed and, where needed, the iteration goes on from
/// it: any tolerance down to 1e-12 can be asked for.
/// Eisenstat, Elman & Schultz, SIAM J. Numer. Anal. 20 (1983) 345-357.
/// b is float: a relative change of the drive by 6e-8 at most. Two reductions per cycle; collective.
SolveReport solve_gcr(const par::Communicator& comm, Hierarchy& hierarchy, Operator& k,
                      const Packed<float>& b, Packed<double>& x, const SolveOptions& options);

}  // namespace porefines::flow
