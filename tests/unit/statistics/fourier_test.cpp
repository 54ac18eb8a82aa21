#include "statistics/fourier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "base/error.hpp"

namespace riffle::fourier_test {
namespace {

std::vector<double> noise(std::size_t n, std::uint64_t seed = 1) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double> x(n);
    for (double& v : x) v = normal(generator);
    return x;
}

std::vector<Complex> complex_noise(std::size_t n) {
    const std::vector<double> re = noise(n, 2);
    const std::vector<double> im = noise(n, 3);
    std::vector<Complex> x(n);
    for (std::size_t j = 0; j < n; ++j) x[j] = {re[j], im[j]};
    return x;
}

Complex direct_sum(const std::vector<Complex>& x, std::size_t k) {
    Complex sum;
    const std::size_t n = x.size();
    for (std::size_t j = 0; j < n; ++j) {
        const double turns = static_cast<double>(j * k % n) / static_cast<double>(n);
        sum += x[j] * std::polar(1.0, -2 * std::numbers::pi * turns);
    }
    return sum;
}

double norm(const std::vector<Complex>& x) {
    double sum = 0;
    for (const Complex& v : x) sum += std::norm(v);
    return std::sqrt(sum);
}

/// Rounding of a value of the transform: eps per addition in the direct sum, log n levels in the fast one,
/// the phases to a few eps; the chirp adds a factor of a few. |X_k| is at most sqrt(n) |x|.
double rounding(std::size_t n, double input_norm) {
    return 20 * std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(n)) * input_norm *
           (1 + std::log2(static_cast<double>(n)));
}

// Products of small factors, primes, products of large primes, powers: each way through the library.
constexpr std::size_t lengths[] = {1,  2,  3,  4,   5,   7,   8,   12,   31,   37,
                                   60, 74, 97, 128, 221, 243, 509, 1018, 1024, 1369};

TEST(Fourier, ComplexTransformIsTheSumAndReturns) {
    for (const std::size_t n : lengths) {
        SCOPED_TRACE(n);
        const std::vector<Complex> x = complex_noise(n);
        std::vector<Complex> y = x;
        const FourierTransform transform(n);
        transform.forward(y);
        for (std::size_t k = 0; k < n; ++k) {
            ASSERT_LT(std::abs(y[k] - direct_sum(x, k)), rounding(n, norm(x)));
        }
        // Parseval.
        EXPECT_NEAR(norm(y) / std::sqrt(static_cast<double>(n)), norm(x), rounding(n, norm(x)));
        transform.inverse(y);
        for (std::size_t j = 0; j < n; ++j) ASSERT_LT(std::abs(x[j] - y[j]), rounding(n, 1));
    }
}

TEST(Fourier, RealTransformIsTheSumAndReturns) {
    for (const std::size_t n : lengths) {
        SCOPED_TRACE(n);
        const std::vector<double> x = noise(n);
        const std::vector<Complex> as_complex(x.begin(), x.end());
        const std::vector<Complex> transformed = fourier_transform(x);
        ASSERT_EQ(transformed.size(), n / 2 + 1);
        for (std::size_t k = 0; k < transformed.size(); ++k) {
            ASSERT_LT(std::abs(transformed[k] - direct_sum(as_complex, k)), rounding(n, norm(as_complex)));
        }
        const std::vector<double> back = inverse_fourier_transform(transformed, n);
        for (std::size_t j = 0; j < n; ++j) ASSERT_NEAR(x[j], back[j], rounding(n, 1));
    }
}

TEST(Fourier, LongPrimeLengthKeepsItsDigits) {
    // A sine of whole cycles stands at its frequency alone; 100 003 is prime.
    constexpr std::size_t n = 100003;
    constexpr std::size_t cycles = 12345;
    std::vector<double> x(n);
    for (std::size_t j = 0; j < n; ++j) {
        x[j] = std::cos(2 * std::numbers::pi * static_cast<double>(j * cycles % n) / static_cast<double>(n));
    }
    const std::vector<Complex> transformed = fourier_transform(x);
    const double size = std::sqrt(0.5 * static_cast<double>(n));
    EXPECT_LT(std::abs(transformed[cycles] - 0.5 * static_cast<double>(n)), rounding(n, size));
    for (const std::size_t k : {std::size_t{0}, cycles - 1, cycles + 1, n / 2}) {
        EXPECT_LT(std::abs(transformed[k]), rounding(n, size));
    }
}

TEST(Fourier, PlaneIsTheSumInBothDirections) {
    constexpr std::size_t rows = 6;
    constexpr std::size_t columns = 37;
    const std::vector<Complex> x = complex_noise(rows * columns);
    std::vector<Complex> y = x;
    fourier_transform_2d(y, rows, columns);
    for (std::size_t l = 0; l < rows; ++l) {
        for (std::size_t k = 0; k < columns; ++k) {
            Complex sum;
            for (std::size_t j = 0; j < rows; ++j) {
                for (std::size_t i = 0; i < columns; ++i) {
                    const double turns =
                        static_cast<double>(j * l) / rows + static_cast<double>(i * k) / columns;
                    sum += x[j * columns + i] * std::polar(1.0, -2 * std::numbers::pi * turns);
                }
            }
            // The phases of the direct sum lose up to rows + columns in digits.
            ASSERT_LT(std::abs(sum - y[l * columns + k]), 40 * rounding(rows * columns, norm(x)));
        }
    }
    inverse_fourier_transform_2d(y, rows, columns);
    for (std::size_t j = 0; j < x.size(); ++j) ASSERT_LT(std::abs(x[j] - y[j]), rounding(x.size(), 1));
}

TEST(Fourier, BoxIsTheSumInItsThreeDirections) {
    constexpr std::size_t layers = 5;
    constexpr std::size_t rows = 6;
    constexpr std::size_t columns = 9;
    const std::vector<Complex> x = complex_noise(layers * rows * columns);
    std::vector<Complex> y = x;
    fourier_transform_3d(y, layers, rows, columns);
    const auto at = [](std::size_t k, std::size_t j, std::size_t i) { return (k * rows + j) * columns + i; };
    for (std::size_t place = 0; place < x.size(); ++place) {
        Complex sum;
        for (std::size_t other = 0; other < x.size(); ++other) {
            const double turns =
                static_cast<double>((place / at(1, 0, 0)) * (other / at(1, 0, 0))) / layers +
                static_cast<double>((place / columns % rows) * (other / columns % rows)) / rows +
                static_cast<double>((place % columns) * (other % columns)) / columns;
            sum += x[other] * std::polar(1.0, -2 * std::numbers::pi * turns);
        }
        ASSERT_LT(std::abs(sum - y[place]), 40 * rounding(x.size(), norm(x)));
    }
    inverse_fourier_transform_3d(y, layers, rows, columns);
    for (std::size_t j = 0; j < x.size(); ++j) ASSERT_LT(std::abs(x[j] - y[j]), rounding(x.size(), 1));
}

TEST(Fourier, WaveStandsAtItsSignedFrequencies) {
    // exp(i (k x + omega t)) of 3 cycles along the columns and -2 along the rows.
    constexpr std::size_t rows = 10;
    constexpr std::size_t columns = 15;
    std::vector<Complex> x(rows * columns);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const double turns = 3.0 * static_cast<double>(i) / columns - 2.0 * static_cast<double>(j) / rows;
            x[j * columns + i] = std::polar(1.0, 2 * std::numbers::pi * turns);
        }
    }
    fourier_transform_2d(x, rows, columns);
    const std::vector<double> along_columns = two_sided_frequencies(columns, 1.0 / columns);
    const std::vector<double> along_rows = two_sided_frequencies(rows, 1.0 / rows);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const bool there = std::lround(along_columns[i]) == 3 && std::lround(along_rows[j]) == -2;
            EXPECT_NEAR(std::abs(x[j * columns + i]), there ? 150.0 : 0.0, 1e-11);
        }
    }
}

TEST(Fourier, FrequenciesOfEvenAndOddLengths) {
    EXPECT_EQ(one_sided_frequencies(4, 0.5), (std::vector<double>{0, 0.5, 1}));
    EXPECT_EQ(one_sided_frequencies(5, 0.2), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(two_sided_frequencies(4, 0.5), (std::vector<double>{0, 0.5, -1, -0.5}));
    EXPECT_EQ(two_sided_frequencies(5, 0.2), (std::vector<double>{0, 1, 2, -2, -1}));
}

TEST(Fourier, FastLengths) {
    EXPECT_EQ(fast_length(0), 1U);
    EXPECT_EQ(fast_length(7), 8U);
    EXPECT_EQ(fast_length(121), 125U);
    EXPECT_EQ(fast_length(1021), 1024U);
}

TEST(Fourier, RefusesWrongSizes) {
    EXPECT_THROW(FourierTransform(0), InputError);
    EXPECT_THROW((void)fourier_transform({}), InputError);
    std::vector<Complex> x(5);
    EXPECT_THROW(FourierTransform(4).forward(x), InputError);
    EXPECT_THROW(fourier_transform_2d(x, 2, 3), InputError);
    EXPECT_THROW(fourier_transform_3d(x, 2, 3, 1), InputError);
    EXPECT_THROW((void)inverse_fourier_transform(x, 5), InputError);
}

}  // namespace
}  // namespace riffle::fourier_test
