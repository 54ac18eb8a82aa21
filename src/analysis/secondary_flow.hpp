#pragma once

#include <cstddef>
#include <vector>

#include "analysis/mean_flow.hpp"

namespace riffle::inline analysis {

// The mean motion across the flow, (V, W), and what the averaging has left in it of the fluctuation.

/// V and W over the cells of a section above a height, m/s; not-a-number elsewhere. Where the channel is
/// periodic across, the mean of V at each height is taken away: the drift of a layer as a whole is no cell.
struct SecondaryFlow {
    std::vector<double> v, w;  ///< [iz * y.size() + iy]
};
[[nodiscard]] SecondaryFlow secondary_flow(const MeanFlow& field, const FieldSums& section, double above,
                                           bool periodic);

/// Means of the speed sqrt(V^2 + W^2) over the cells, m/s.
struct SecondaryStrength {
    double mean = 0;
    double root_mean_square = 0;
    double largest = 0;
};
[[nodiscard]] SecondaryStrength strength_of(const SecondaryFlow& flow);

/// Strength of the means over groups of successive windows, averaged over the groups.
struct AveragedStrength {
    double time = 0;  ///< averaging time, s
    SecondaryStrength strength;
};

/// How the strength falls with the averaging time, and what of it stays.
struct SecondarySurvival {
    std::vector<AveragedStrength> averaged;  ///< of 1, 2, 4, ... windows, and of all
    /// Mean square of the part that is the same in all windows, from the products of different windows, in
    /// which the fluctuation left in each has no part: may come out below zero, m2/s2.
    Estimate persistent;
    double single = 0;  ///< mean square in single windows, m2/s2
    /// Mean square expected after averaging over `time`, s, the fluctuation falling as 1/time.
    [[nodiscard]] double mean_square_after(double time, double interval) const {
        return persistent.value + (single - persistent.value) * interval / time;
    }
};
/// Needs two windows for `persistent`, else it is not-a-number with an infinite interval.
[[nodiscard]] SecondarySurvival secondary_survival(const MeanFlow& field, double above, bool periodic);

/// Streamfunction of (V, W) = (d psi/dz, -d psi/dy), m2/s, from V above the bed level.
[[nodiscard]] std::vector<double> streamfunction(const MeanFlow& field, const SecondaryFlow& flow);

/// Its mean over the depth at each place across the channel, m2/s.
[[nodiscard]] std::vector<double> depth_mean_streamfunction(const MeanFlow& field, const SecondaryFlow& flow);

/// A cell of the secondary flow: a stretch across the channel in which the streamfunction has one sign beyond
/// its interval.
struct SecondaryCell {
    double from = 0, to = 0;  ///< m: half way to the next cell of the other sign, or the end of the channel
    bool positive = false;
};
[[nodiscard]] std::vector<SecondaryCell> secondary_cells(const std::vector<double>& y,
                                                         const FieldEstimates& psi, double width);

}  // namespace riffle::inline analysis
