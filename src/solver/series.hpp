#pragma once

#include <cstddef>
#include <vector>

#include "case/case.hpp"
#include "case/end_floor.hpp"
#include "ends/end_lattice.hpp"
#include "record/field.hpp"
#include "solver/simulation.hpp"

namespace riffle::inline solver {

/// One column of the time series of a run.
struct SeriesColumn {
    Field field;
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
    /// Of a field of `fields::time_series` that the run has.
    [[nodiscard]] const std::vector<double>& column(const Field& field) const;
    [[nodiscard]] double last(const Field& field) const;

  private:
    [[nodiscard]] std::vector<double>& values_of(const Field& field);
    /// The account of the open ends.
    template <int D>
    void sample_ends(const SimulationIn<D>& simulation);

    Case case_;
    EndFloors end_floors_;
    LongWaves upstream_waves_;  ///< of the sections of open ends
    LongWaves downstream_waves_;
    std::vector<SeriesColumn> columns_;
};

/// Half the width of the strip along the centreline whose mean velocity is the centreline's, m: half a period
/// of the spheres' lattice across the channel; on smooth beds a twentieth of the width.
[[nodiscard]] double centreline_half_strip(const Case& c);

}  // namespace riffle::inline solver
