#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace riffle::inline statistics {

using Complex = std::complex<double>;

// Convention of all transforms here, of any length n >= 1:
//   forward  X_k = sum_j x_j exp(-2 pi i j k / n), without a factor;
//   inverse  x_j = (1/n) sum_k X_k exp(+2 pi i j k / n).
// Parseval: sum |x_j|^2 = (1/n) sum |X_k|^2. A wave exp(i omega t) stands at the positive frequency omega.

/// The transforms of one length, prepared once for many records. The cost is of order n log n for any length,
/// smallest for products of 2, 3 and 5. One object serves one thread at a time.
class FourierTransform {
  public:
    /// Throws InputError for length 0.
    explicit FourierTransform(std::size_t length);
    ~FourierTransform();
    FourierTransform(FourierTransform&&) noexcept;
    FourierTransform& operator=(FourierTransform&&) noexcept;
    FourierTransform(const FourierTransform&) = delete;
    FourierTransform& operator=(const FourierTransform&) = delete;

    [[nodiscard]] std::size_t length() const;

    /// In place; `values` has the length of the transform (else InputError).
    void forward(std::span<Complex> values) const;
    void inverse(std::span<Complex> values) const;

    /// The n/2 + 1 values k = 0 ... n/2 of the transform of a real record of length n, those of the
    /// frequencies from zero up; the others are their conjugates.
    [[nodiscard]] std::vector<Complex> forward_real(std::span<const double> record) const;

    /// The real record of length n whose forward_real() is `spectrum` (n/2 + 1 values). The imaginary parts
    /// of the values at frequency zero and, for even n, at n/2 are not used.
    [[nodiscard]] std::vector<double> inverse_real(std::span<const Complex> spectrum) const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// forward_real() for a single record.
[[nodiscard]] std::vector<Complex> fourier_transform(std::span<const double> record);

/// inverse_real() for a single spectrum; `length` is that of the record.
[[nodiscard]] std::vector<double> inverse_fourier_transform(std::span<const Complex> spectrum,
                                                            std::size_t length);

/// Transform of a plane in both directions, in place: values[j * columns + i] is the value at row j and
/// column i, before as after. The inverse divides by rows * columns. Throws InputError where the sizes
/// disagree.
void fourier_transform_2d(std::span<Complex> values, std::size_t rows, std::size_t columns);
void inverse_fourier_transform_2d(std::span<Complex> values, std::size_t rows, std::size_t columns);

/// The same of a box in its three directions, in place: values[(k * rows + j) * columns + i] is the value in
/// layer k, row j, column i. The inverse divides by layers * rows * columns. The same bits for any number of
/// threads.
void fourier_transform_3d(std::span<Complex> values, std::size_t layers, std::size_t rows,
                          std::size_t columns);
void inverse_fourier_transform_3d(std::span<Complex> values, std::size_t layers, std::size_t rows,
                                  std::size_t columns);

/// Frequencies (cycles per unit of `step`) of the n/2 + 1 values of a real record of length n >= 1 sampled at
/// intervals `step`: k / (n step).
[[nodiscard]] std::vector<double> one_sided_frequencies(std::size_t length, double step);

/// Signed frequencies of the n values of a complex transform in their order: k / (n step) for k < n/2 rounded
/// up, (k - n) / (n step) above; so the value at n/2 of an even length is negative.
[[nodiscard]] std::vector<double> two_sided_frequencies(std::size_t length, double step);

/// The smallest length of at least `length` that is a product of 2, 3 and 5.
[[nodiscard]] std::size_t fast_length(std::size_t length);

}  // namespace riffle::inline statistics
