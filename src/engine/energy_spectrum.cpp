#include "engine/energy_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "ends/time_table.hpp"

namespace riffle::inline engine {

EnergySpectrum::EnergySpectrum(const std::filesystem::path& path) {
    TwoColumns table = read_two_columns(path, {"wavenumber", "1/m"}, {{"energy", "m3/s2"}}, 0.0);
    if (!(table.first.front() > 0.0)) {
        throw FileError(fmt::format("{}: wavenumber is {:g} in the first row; expected more than 0",
                                    path.string(), table.first.front()));
    }
    wavenumber_ = std::move(table.first);
    energy_ = std::move(table.second);
}

double EnergySpectrum::at(double wavenumber) const {
    if (wavenumber < wavenumber_.front() || wavenumber > wavenumber_.back()) return 0.0;
    const TablePlace place = place_in(wavenumber_, wavenumber);
    const double low = energy_[place.low];
    const double high = energy_[place.high];
    if (low == 0.0 || high == 0.0 || place.low == place.high) return place.in(energy_);
    const double share = std::log(wavenumber / wavenumber_[place.low]) /
                         std::log(wavenumber_[place.high] / wavenumber_[place.low]);
    return low * std::pow(high / low, share);
}

double EnergySpectrum::velocity_rms(double largest) const {
    const double first = wavenumber_.front();
    const double last = std::min(largest, wavenumber_.back());
    if (!(last > first)) return 0.0;
    constexpr int parts = 4000;
    const double step = (last - first) / parts;
    double energy = 0.0;
    for (int i = 0; i < parts; ++i) energy += step * at(first + (i + 0.5) * step);
    return std::sqrt(2.0 / 3.0 * energy);
}

}  // namespace riffle::inline engine
