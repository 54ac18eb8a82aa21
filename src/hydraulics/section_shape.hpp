#pragma once

#include <vector>

namespace riffle::inline hydraulics {

/// What the water of a channel of one cross-section has at a depth over the lowest point of it, all over the
/// width of the channel: its mean depth over that width (the area), the share of the width that its surface
/// takes, the wetted perimeter. Between the depths that it is given at the surface widens along straight
/// lines; above the last one the sides are upright.
class SectionShape {
  public:
    /// `depth` (m): rising from 0; `width`: of the surface there, over that of the channel, none of them
    /// negative and the last two not 0; `perimeter` (m): wetted, over the width of the channel.
    SectionShape(std::vector<double> depth, std::vector<double> width, std::vector<double> perimeter);

    /// Area over the width of the channel, m. 0 below the lowest point.
    [[nodiscard]] double area(double depth) const;
    /// Width of the surface over that of the channel.
    [[nodiscard]] double top_width(double depth) const;
    /// Area over the wetted perimeter, m.
    [[nodiscard]] double hydraulic_radius(double depth) const;
    /// Integral of area() from the lowest point on, m2: the force of still water is rho g times it.
    [[nodiscard]] double pressure_integral(double depth) const;
    /// Depth of an area over the width of the channel, m.
    [[nodiscard]] double depth_of_area(double area) const;

    /// Integral of sqrt(top_width/area) from the lowest point on, m^(1/2): sqrt(g) times it is what a
    /// characteristic of long waves carries beside the velocity, 2 sqrt(g h) in a rectangle (Stoker 1957).
    [[nodiscard]] double wave_integral(double depth) const;
    /// Depth of such an integral, m.
    [[nodiscard]] double depth_of_wave_integral(double integral) const;

  private:
    struct Place {
        std::size_t interval;
        double over;  ///< its lower end, m
    };
    [[nodiscard]] Place place_of(double depth) const;
    [[nodiscard]] double slope_in(std::size_t interval) const;
    [[nodiscard]] double wave_integral_between(double from, double to) const;

    std::vector<double> depth_, width_, perimeter_;
    std::vector<double> area_, pressure_, wave_;  ///< at the depths
};

/// Depth of critical flow with a discharge over the width of the channel (m2/s), q^2 top_width = g area^3, m:
/// the largest where a section with floodplains has more than one.
[[nodiscard]] double critical_depth(const SectionShape& section, double gravity, double unit_discharge);

/// Depth behind a jump from a depth (m) with a velocity (m/s): the other one of the same momentum function.
[[nodiscard]] double sequent_depth(const SectionShape& section, double gravity, double depth,
                                   double velocity);

}  // namespace riffle::inline hydraulics
