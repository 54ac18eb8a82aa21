#pragma once

#include <cstddef>
#include <vector>

namespace riffle::inline ends {

/// Sound beyond an open end, as numbers that a run needs to go on with the same bits: pressures over the
/// density, m2/s2.
struct SoundBeyondEnd {
    std::vector<double>
        slow;                 ///< of each bin: the pressure before the end over that of the section, smoothed
    std::vector<double> now;  ///< of each bin along its nodes, from inside of the channel outwards
    std::vector<double> change;  ///< of the same in the last step

    bool operator==(const SoundBeyondEnd&) const = default;
};

/// Sound that leaves the channel through an end (docs/theory.md 20): in bins over the depth and across the
/// channel, the pressure that the water before the end has over that of the section goes on along the buffer
/// with the speed of sound (Sommerfeld's radiation condition). With the velocity p/(rho c) beside it, nothing
/// comes back of sound that runs along the channel.
class OutgoingSound {
  public:
    /// Where sound is followed: along nodes a spacing apart over a length (m), in bins over the depth and
    /// across.
    struct Grid {
        double spacing = 0.0;
        double length = 0.0;
        int bins_upright = 1;
        int bins_across = 1;
    };

    explicit OutgoingSound(const Grid& grid);

    /// Place over the depth and across, each from 0 to 1.
    struct Place {
        double upright = 0.0;
        double across = 0.0;
    };

    /// Begin to gather the water before the end.
    void clear();
    /// Water at a place: its weight, and its pressure (over the density) above that of the section.
    void add(const Place& place, double weight, double pressure);
    /// Let what has been gathered go on for dt (s) with a speed (m/s). What changes slower than `slow_time`
    /// (s) is no sound; no pressure above `most` (m2/s2) is; and a bin with less than half of `full` weight
    /// has none.
    void advance(SoundBeyondEnd& sound, double speed, double slow_time, double full, double most, double dt);

    /// Pressure over the density, or its change, at a distance (m) from where the water is gathered.
    [[nodiscard]] double at(const std::vector<double>& nodes, double distance, const Place& place) const;

    [[nodiscard]] std::size_t bins() const { return weight_.size(); }

  private:
    [[nodiscard]] std::size_t bin(std::size_t upright, std::size_t across) const;
    void carry(std::vector<double>& nodes, double courant) const;

    Grid grid_;
    std::size_t nodes_;
    std::vector<double> weight_, pressure_;  ///< by bin
};

}  // namespace riffle::inline ends
