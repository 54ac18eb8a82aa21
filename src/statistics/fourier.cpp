#include "statistics/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <kissfft/kissfft.hh>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace riffle::inline statistics {

namespace {

/// Factors above this cost more as a sum than the length as a convolution.
constexpr std::size_t largest_direct_factor = 31;

std::size_t largest_prime_factor(std::size_t n) {
    std::size_t largest = 1;
    for (std::size_t p = 2; p * p <= n; ++p) {
        for (; n % p == 0; n /= p) largest = p;
    }
    return std::max(largest, n);
}

void require_length(std::size_t found, std::size_t expected, const char* what) {
    if (found == expected) return;
    throw InputError("Fourier transform: " + std::string(what) + " has " + std::to_string(found) +
                     " values instead of " + std::to_string(expected));
}

/// Forward transform whose length has no large prime factor.
class DirectTransform {
  public:
    explicit DirectTransform(std::size_t length) : plan_(length, false), result_(length) {}

    void operator()(std::span<Complex> values) const {
        plan_.transform(values.data(), result_.data());
        std::copy(result_.begin(), result_.end(), values.begin());
    }

  private:
    kissfft<double> plan_;
    mutable std::vector<Complex> result_;
};

/// Forward transform of any length as a cyclic convolution with a chirp: L. Bluestein (1970), IEEE Trans.
/// Audio Electroacoustics 18, 451. From 2 j k = j^2 + k^2 - (k - j)^2.
class ChirpTransform {
  public:
    explicit ChirpTransform(std::size_t length)
        : direct_(fast_length(2 * length - 1)), chirp_(length), filter_(fast_length(2 * length - 1)) {
        const double unit = std::numbers::pi / static_cast<double>(length);
        std::size_t square = 0;  // j^2 modulo 2 n: the phase keeps its digits
        for (std::size_t j = 0; j < length; ++j) {
            chirp_[j] = std::polar(1.0, unit * static_cast<double>(square));
            square = (square + 2 * j + 1) % (2 * length);
        }
        filter_[0] = chirp_[0];
        for (std::size_t j = 1; j < length; ++j) filter_[j] = filter_[filter_.size() - j] = chirp_[j];
        direct_(filter_);
        for (Complex& f : filter_) f /= static_cast<double>(filter_.size());
        work_.resize(filter_.size());
    }

    void operator()(std::span<Complex> values) const {
        std::fill(work_.begin(), work_.end(), Complex{});
        for (std::size_t j = 0; j < values.size(); ++j) work_[j] = values[j] * std::conj(chirp_[j]);
        direct_(work_);
        // The inverse is the conjugate of the forward transform of the conjugate.
        for (std::size_t j = 0; j < work_.size(); ++j) work_[j] = std::conj(work_[j] * filter_[j]);
        direct_(work_);
        for (std::size_t j = 0; j < values.size(); ++j) values[j] = std::conj(work_[j] * chirp_[j]);
    }

  private:
    DirectTransform direct_;
    std::vector<Complex> chirp_, filter_;
    mutable std::vector<Complex> work_;
};

/// Forward transform by whichever way is short.
class ForwardTransform {
  public:
    explicit ForwardTransform(std::size_t length) {
        if (largest_prime_factor(length) <= largest_direct_factor) {
            direct_.emplace(length);
        } else {
            chirp_.emplace(length);
        }
    }

    void operator()(std::span<Complex> values) const {
        if (direct_) {
            (*direct_)(values);
        } else {
            (*chirp_)(values);
        }
    }

  private:
    std::optional<DirectTransform> direct_;
    std::optional<ChirpTransform> chirp_;
};

}  // namespace

class FourierTransform::Implementation {
  public:
    explicit Implementation(std::size_t length) : length_(length) {
        if (length == 0) throw InputError("Fourier transform: the record is empty");
    }

    [[nodiscard]] std::size_t length() const { return length_; }

    void forward(std::span<Complex> values) const {
        if (!whole_) whole_.emplace(length_);
        (*whole_)(values);
    }

    /// A real record of even length is the transform of its even and odd samples as one complex record of
    /// half the length: Press et al. (2007), Numerical Recipes, eq. 12.3.6.
    [[nodiscard]] std::vector<Complex> forward_real(std::span<const double> record) const {
        if (length_ % 2 != 0) {
            std::vector<Complex> values(record.begin(), record.end());
            forward(values);
            values.resize(length_ / 2 + 1);
            return values;
        }
        prepare_half();
        const std::size_t half = length_ / 2;
        std::vector<Complex> packed(half);
        for (std::size_t j = 0; j < half; ++j) packed[j] = {record[2 * j], record[2 * j + 1]};
        (*half_)(packed);
        std::vector<Complex> spectrum(half + 1);
        for (std::size_t k = 0; k <= half; ++k) {
            const Complex a = packed[k % half];
            const Complex b = std::conj(packed[(half - k) % half]);
            spectrum[k] = 0.5 * (a + b) - Complex(0.0, 0.5) * twiddles_[k] * (a - b);
        }
        return spectrum;
    }

    /// The way back from there.
    [[nodiscard]] std::vector<double> inverse_real(std::span<const Complex> spectrum) const {
        std::vector<double> record(length_);
        if (length_ % 2 != 0) {
            std::vector<Complex> values(length_);
            values[0] = spectrum[0].real();
            for (std::size_t k = 1; k <= length_ / 2; ++k) {
                values[length_ - k] = spectrum[k];
                values[k] = std::conj(spectrum[k]);
            }
            forward(values);
            const double factor = 1.0 / static_cast<double>(length_);
            std::transform(values.begin(), values.end(), record.begin(),
                           [factor](const Complex& v) { return factor * v.real(); });
            return record;
        }
        prepare_half();
        const std::size_t half = length_ / 2;
        const auto at = [&](std::size_t k) {
            return k % half == 0 ? Complex(spectrum[k].real()) : spectrum[k];
        };
        std::vector<Complex> packed(half);
        for (std::size_t k = 0; k < half; ++k) {
            const Complex a = at(k);
            const Complex b = std::conj(at(half - k));
            packed[k] = std::conj(a + b + Complex(0.0, 1.0) * std::conj(twiddles_[k]) * (a - b));
        }
        (*half_)(packed);
        const double factor = 1.0 / static_cast<double>(length_);
        for (std::size_t j = 0; j < half; ++j) {
            record[2 * j] = factor * packed[j].real();
            record[2 * j + 1] = -factor * packed[j].imag();
        }
        return record;
    }

  private:
    void prepare_half() const {
        if (half_) return;
        const std::size_t half = length_ / 2;
        half_.emplace(half);
        twiddles_.resize(half + 1);
        const double unit = std::numbers::pi / static_cast<double>(half);
        for (std::size_t k = 0; k <= half; ++k) {
            twiddles_[k] = std::polar(1.0, -unit * static_cast<double>(k));
        }
    }

    std::size_t length_;
    // Made when first used.
    mutable std::optional<ForwardTransform> whole_;
    mutable std::optional<ForwardTransform> half_;  // real records of even length
    mutable std::vector<Complex> twiddles_;
};

FourierTransform::FourierTransform(std::size_t length)
    : implementation_(std::make_unique<Implementation>(length)) {}
FourierTransform::~FourierTransform() = default;
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;

std::size_t FourierTransform::length() const { return implementation_->length(); }

void FourierTransform::forward(std::span<Complex> values) const {
    require_length(values.size(), length(), "the record");
    implementation_->forward(values);
}

void FourierTransform::inverse(std::span<Complex> values) const {
    require_length(values.size(), length(), "the spectrum");
    for (Complex& v : values) v = std::conj(v);
    implementation_->forward(values);
    const double factor = 1.0 / static_cast<double>(length());
    for (Complex& v : values) v = factor * std::conj(v);
}

std::vector<Complex> FourierTransform::forward_real(std::span<const double> record) const {
    require_length(record.size(), length(), "the record");
    return implementation_->forward_real(record);
}

std::vector<double> FourierTransform::inverse_real(std::span<const Complex> spectrum) const {
    require_length(spectrum.size(), length() / 2 + 1, "the spectrum of a real record");
    return implementation_->inverse_real(spectrum);
}

std::vector<Complex> fourier_transform(std::span<const double> record) {
    return FourierTransform(record.size()).forward_real(record);
}

std::vector<double> inverse_fourier_transform(std::span<const Complex> spectrum, std::size_t length) {
    return FourierTransform(length).inverse_real(spectrum);
}

namespace {

/// Transform of `lines` lines whose values stand `stride` apart and which begin side by side, from `first`
/// on: several at a time, so that whole cache lines are read.
template <class Transform>
void transform_lines(std::span<Complex> values, std::size_t first, std::size_t lines, std::size_t stride,
                     const FourierTransform& plan, Transform&& transform) {
    constexpr std::size_t group = 8;
    const std::size_t length = plan.length();
    std::vector<Complex> gathered(group * length);
    for (std::size_t begin = 0; begin < lines; begin += group) {
        const std::size_t count = std::min(group, lines - begin);
        const std::span<Complex> side_by_side = values.subspan(first + begin);
        for (std::size_t j = 0; j < length; ++j) {
            for (std::size_t i = 0; i < count; ++i) gathered[i * length + j] = side_by_side[j * stride + i];
        }
        for (std::size_t i = 0; i < count; ++i) {
            transform(plan, std::span(gathered).subspan(i * length, length));
        }
        for (std::size_t j = 0; j < length; ++j) {
            for (std::size_t i = 0; i < count; ++i) side_by_side[j * stride + i] = gathered[i * length + j];
        }
    }
}

template <class Transform>
void transform_plane(std::span<Complex> values, std::size_t rows, std::size_t columns,
                     Transform&& transform) {
    require_length(values.size(), rows * columns, "the plane");
    const FourierTransform along_row(columns);
    for (std::size_t j = 0; j < rows; ++j) transform(along_row, values.subspan(j * columns, columns));
    transform_lines(values, 0, columns, columns, FourierTransform(rows), transform);
}

template <class Transform>
void transform_box(std::span<Complex> values, std::size_t layers, std::size_t rows, std::size_t columns,
                   const Transform& transform) {
    const std::size_t plane = rows * columns;
    require_length(values.size(), layers * plane, "the box");
    parallel_blocks(layers, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            transform_plane(values.subspan(k * plane, plane), rows, columns, transform);
        }
    });
    parallel_blocks(rows, 1, [&](std::size_t begin, std::size_t end) {
        const FourierTransform across_layers(layers);
        for (std::size_t j = begin; j < end; ++j) {
            transform_lines(values, j * columns, columns, plane, across_layers, transform);
        }
    });
}

constexpr auto forward_line = [](const FourierTransform& t, std::span<Complex> line) { t.forward(line); };
constexpr auto inverse_line = [](const FourierTransform& t, std::span<Complex> line) { t.inverse(line); };

}  // namespace

void fourier_transform_2d(std::span<Complex> values, std::size_t rows, std::size_t columns) {
    transform_plane(values, rows, columns, forward_line);
}

void inverse_fourier_transform_2d(std::span<Complex> values, std::size_t rows, std::size_t columns) {
    transform_plane(values, rows, columns, inverse_line);
}

void fourier_transform_3d(std::span<Complex> values, std::size_t layers, std::size_t rows,
                          std::size_t columns) {
    transform_box(values, layers, rows, columns, forward_line);
}

void inverse_fourier_transform_3d(std::span<Complex> values, std::size_t layers, std::size_t rows,
                                  std::size_t columns) {
    transform_box(values, layers, rows, columns, inverse_line);
}

std::vector<double> one_sided_frequencies(std::size_t length, double step) {
    std::vector<double> frequencies(length / 2 + 1);
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
        frequencies[k] = static_cast<double>(k) / (static_cast<double>(length) * step);
    }
    return frequencies;
}

std::vector<double> two_sided_frequencies(std::size_t length, double step) {
    std::vector<double> frequencies(length);
    for (std::size_t k = 0; k < length; ++k) {
        const double cycles = static_cast<double>(k) - (2 * k < length ? 0.0 : static_cast<double>(length));
        frequencies[k] = cycles / (static_cast<double>(length) * step);
    }
    return frequencies;
}

std::size_t fast_length(std::size_t length) {
    for (std::size_t n = std::max<std::size_t>(length, 1);; ++n) {
        std::size_t rest = n;
        for (const std::size_t p : {2U, 3U, 5U}) {
            while (rest % p == 0) rest /= p;
        }
        if (rest == 1) return n;
    }
}

}  // namespace riffle::inline statistics
