// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense.hpp"

#include <gsl/gsl_linalg.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/loop_targets.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::numeric {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Elements touched, some 20 us: in these loops the other threads are still awake from the last one.
constexpr double worth_a_thread = 1 << 15;

/// Fewest of a loop's iterations that are worth a thread, where each touches so many elements.
std::size_t grain_of(double elements)
{
    return static_cast<std::size_t>(std::max(1.0, worth_a_thread / std::max(1.0, elements)));
}

/// C -= A B', all by columns, those of A and B @p stride apart and those of C too. Eigen's products are compiled for
/// the oldest processor.
HDCONJ_TARGETS
void subtract_product(Index rows, Index columns, Index inner, double const* a, double const* b, double* c, Index stride)
{
    using Quad [[gnu::vector_size(4 * sizeof(double))]] = double;
    constexpr Index across = 4, down = 8;  // of C at once: sixteen registers hold their sums
    Index const whole_rows = rows - rows % down, whole_columns = columns - columns % across;
    for (Index j = 0; j < whole_columns; j += across)
        for (Index i = 0; i < whole_rows; i += down) {
            Quad sum[across][2] = {};
            for (Index k = 0; k < inner; ++k) {
                Quad part[2];
                std::memcpy(part, a + i + k * stride, sizeof part);
                for (Index l = 0; l < across; ++l)
                    for (Index h = 0; h < 2; ++h)
                        sum[l][h] += part[h] * b[j + l + k * stride];
            }
            for (Index l = 0; l < across; ++l) {
                Quad part[2];
                std::memcpy(part, c + i + (j + l) * stride, sizeof part);
                for (Index h = 0; h < 2; ++h)
                    part[h] -= sum[l][h];
                std::memcpy(c + i + (j + l) * stride, part, sizeof part);
            }
        }
    for (Index j = 0; j < columns; ++j)
        for (Index i = j < whole_columns ? whole_rows : 0; i < rows; ++i) {
            double sum = 0;
            for (Index k = 0; k < inner; ++k)
                sum += a[i + k * stride] * b[j + k * stride];
            c[i + j * stride] -= sum;
        }
}

std::size_t tiles_of(Index length, Index tile)
{
    return static_cast<std::size_t>((length + tile - 1) / tile);
}

}  // namespace

bool all_finite(MatrixXd const& a, int threads)
{
    std::vector<unsigned char> finite(static_cast<std::size_t>(a.cols()));
    // what is not finite is not zero less itself; of allFinite() no vector instructions are made
    parallel_for(finite.size(), threads, grain_of(static_cast<double>(a.rows())), [&](std::size_t j) {
        auto const column = a.col(static_cast<Index>(j)).array();
        finite[j] = (column - column).sum() == 0;
    });
    return std::all_of(finite.begin(), finite.end(), [](unsigned char f) { return f != 0; });
}

Cholesky::Cholesky(MatrixXd a, int threads) : factor_(std::move(a))
{
    constexpr Index tile = 48;
    constexpr std::size_t tiles_worth_a_thread = 1;
    Index const n = factor_.rows();
    for (Index k = 0; k < n; k += tile) {
        Index const width = std::min(tile, n - k), below = k + width;
        auto corner = factor_.block(k, k, width, width);
        Eigen::LLT<Eigen::Ref<MatrixXd>> const in_place(corner);
        found_ = in_place.info() == Eigen::Success;
        if (!found_)
            return;
        std::size_t const tiles = tiles_of(n - below, tile);
        parallel_for(tiles, threads, tiles_worth_a_thread, [&](std::size_t t) {
            Index const first = below + static_cast<Index>(t) * tile;
            auto rows = factor_.block(first, k, std::min(tile, n - first), width);
            corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rows);
        });
        // what these columns take from all that follow, from the longest on
        parallel_for(tiles, threads, tiles_worth_a_thread, [&](std::size_t t) {
            Index const first = below + static_cast<Index>(t) * tile, size = std::min(tile, n - first);
            double const* const column = factor_.data() + first + k * n;
            subtract_product(n - first, size, width, column, column, factor_.data() + first + first * n, n);
        });
    }
}

VectorXd Cholesky::solve(VectorXd const& b) const
{
    VectorXd x = b;
    factor_.triangularView<Eigen::Lower>().solveInPlace(x);
    factor_.triangularView<Eigen::Lower>().adjoint().solveInPlace(x);
    return x;
}

LU::LU(MatrixXd const& a) : factors_(a), order_(static_cast<std::size_t>(a.rows()))
{
    auto matrix = gsl_matrix_view_array(factors_.data(), order_.size(), order_.size());
    gsl_permutation order{order_.size(), order_.data()};
    int sign = 0;
    gsl_linalg_LU_decomp(&matrix.matrix, &order, &sign);
}

bool LU::is_singular() const
{
    return (factors_.diagonal().array() == 0).any();
}

VectorXd LU::solve(VectorXd const& b) const
{
    VectorXd x(b.size());
    for (Index i = 0; i < b.size(); ++i)
        x[i] = b[static_cast<Index>(order_[static_cast<std::size_t>(i)])];
    factors_.triangularView<Eigen::UnitLower>().solveInPlace(x);
    factors_.triangularView<Eigen::Upper>().solveInPlace(x);
    return x;
}

MatrixXd LU::inverse() const
{
    MatrixXd all(factors_.rows(), factors_.cols());
    for (Index i = 0; i < all.cols(); ++i)
        all.col(i) = solve(VectorXd::Unit(all.rows(), i));
    return all;
}

}  // namespace hdconj::numeric
