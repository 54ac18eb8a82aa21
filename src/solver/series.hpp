#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "solver/simulation.hpp"

namespace riffle {

/// One column of the time series of a run.
struct SeriesColumn {
    std::string name;
    std::string unit;
    std::string long_name;
    std::vector<double> values;
};

/// Whole-flow quantities against time, the rows of `/time_series`.
class TimeSeries {
  public:
    explicit TimeSeries(const Case& c);

    /// Add the row of the present state. `mean_level`: of the newest surface sample, m.
    template <int D>
    void sample(const SimulationIn<D>& simulation, double mean_level);
    /// Put a mean level that became known after the sample into the last row.
    void set_mean_level(double level);

    [[nodiscard]] const std::vector<SeriesColumn>& columns() const { return columns_; }
    [[nodiscard]] std::vector<SeriesColumn>& columns() { return columns_; }
    [[nodiscard]] std::size_t rows() const { return columns_.front().values.size(); }
    [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
    [[nodiscard]] double last(const std::string& name) const;

  private:
    Case case_;
    std::vector<SeriesColumn> columns_;
};

/// Half the width of the strip along the centreline whose mean velocity is the centreline's, m: half a period
/// of the spheres' lattice across the channel; on smooth beds a twentieth of the width.
[[nodiscard]] double centreline_half_strip(const Case& c);

}  // namespace riffle
