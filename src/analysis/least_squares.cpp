// SPDX-License-Identifier: MPL-2.0
#include "analysis/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace porefines::analysis {
namespace {

constexpr int most_steps = 200;
using Matrix = std::vector<std::vector<Real>>;

Real square_sum(const std::vector<Real>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), Real{0});
}

/// Columns: derivative of all residuals by each parameter.
Matrix jacobian(const Residuals& residuals, const std::vector<Real>& at) {
  Matrix columns;
  for (std::size_t p = 0; p < at.size(); ++p) {
    const Real h = 1e-6 * std::max(std::abs(at[p]), 1e-6);
    std::vector<Real> low = at;
    std::vector<Real> high = at;
    low[p] -= h;
    high[p] += h;
    std::vector<Real> column = residuals(high);
    const std::vector<Real> other = residuals(low);
    for (std::size_t i = 0; i < column.size(); ++i) {
      column[i] = (column[i] - other[i]) / (2 * h);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

Real dot(const std::vector<Real>& a, const std::vector<Real>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), Real{0});
}

/// Solves a x = b by elimination with pivots; false where a is singular.
bool solve(Matrix a, std::vector<Real> b, std::vector<Real>& x) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      pivot = std::abs(a[i][k]) > std::abs(a[pivot][k]) ? i : pivot;
    }
    if (!(std::abs(a[pivot][k]) > 0)) {
      return false;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) {
        a[i][j] -= factor * a[k][j];
      }
      b[i] -= factor * b[k];
    }
  }
  x.assign(n, 0);
  for (std::size_t k = n; k-- > 0;) {
    Real sum = b[k];
    for (std::size_t j = k + 1; j < n; ++j) {
      sum -= a[k][j] * x[j];
    }
    x[k] = sum / a[k][k];
  }
  return true;
}

Matrix normal_matrix(const Matrix& columns) {
  Matrix out(columns.size(), std::vector<Real>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      out[i][j] = dot(columns[i], columns[j]);
    }
  }
  return out;
}

void add_deviations(LeastSquares& fit, const Residuals& residuals) {
  const std::size_t n = fit.residuals.size();
  const std::size_t p = fit.parameters.size();
  const Matrix normal = normal_matrix(jacobian(residuals, fit.parameters));
  const Real variance = n > p ? fit.sum / static_cast<Real>(n - p) : std::nan("");
  for (std::size_t k = 0; k < p; ++k) {
    std::vector<Real> unit(p, 0);
    unit[k] = 1;
    std::vector<Real> column;
    fit.deviations.push_back(solve(normal, unit, column) ? std::sqrt(variance * column[k])
                                                         : std::nan(""));
  }
}

}  // namespace

LeastSquares least_squares(const Residuals& residuals, std::vector<Real> start) {
  LeastSquares fit{.parameters = std::move(start), .deviations = {}, .residuals = {}};
  fit.residuals = residuals(fit.parameters);
  fit.sum = square_sum(fit.residuals);
  Real damping = 1e-3;
  for (; fit.steps < most_steps && !fit.converged; ++fit.steps) {
    const Matrix columns = jacobian(residuals, fit.parameters);
    Matrix normal = normal_matrix(columns);
    std::vector<Real> down(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      normal[k][k] *= 1 + damping;
      down[k] = -dot(columns[k], fit.residuals);
    }
    std::vector<Real> step;
    if (!solve(normal, down, step)) {
      break;
    }
    std::vector<Real> next = fit.parameters;
    Real change = 0;
    for (std::size_t k = 0; k < next.size(); ++k) {
      next[k] += step[k];
      change = std::max(change, std::abs(step[k]) / std::max(std::abs(next[k]), 1e-12));
    }
    std::vector<Real> tried = residuals(next);
    const Real sum = square_sum(tried);
    if (sum <= fit.sum) {
      fit.parameters = std::move(next);
      fit.residuals = std::move(tried);
      fit.sum = sum;
      damping = std::max(damping / 10, 1e-12);
      fit.converged = change < 1e-10;
    } else {
      damping *= 10;
      fit.converged = change < 1e-12 || damping > 1e12;
    }
  }
  add_deviations(fit, residuals);
  return fit;
}

}  // namespace porefines::analysis
