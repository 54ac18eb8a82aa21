#include "statistics/lagged_products.hpp"

#include <algorithm>
#include <complex>

#include "statistics/fourier.hpp"

namespace riffle::inline statistics {

namespace {

std::vector<Complex> padded_transform(const FourierTransform& transform, std::span<const double> x) {
    std::vector<double> padded(transform.length());
    std::copy(x.begin(), x.end(), padded.begin());
    return transform.forward_real(padded);
}

}  // namespace

std::vector<double> lagged_products(std::span<const double> a, std::span<const double> b,
                                    std::size_t largest_lag) {
    const FourierTransform transform(fast_length(std::max(a.size(), b.size()) + largest_lag));
    const std::vector<Complex> of_a = padded_transform(transform, a);
    std::vector<Complex> spectrum = padded_transform(transform, b);
    for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= std::conj(of_a[k]);
    std::vector<double> products = transform.inverse_real(spectrum);
    // Negative lags stand at the end.
    std::rotate(products.begin(), products.end() - static_cast<std::ptrdiff_t>(largest_lag), products.end());
    products.resize(2 * largest_lag + 1);
    return products;
}

std::vector<double> lagged_products(std::span<const double> a, std::size_t largest_lag) {
    const FourierTransform transform(fast_length(a.size() + largest_lag));
    std::vector<Complex> spectrum = padded_transform(transform, a);
    for (Complex& v : spectrum) v = std::norm(v);
    std::vector<double> products = transform.inverse_real(spectrum);
    products.resize(largest_lag + 1);
    return products;
}

}  // namespace riffle::inline statistics
