#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/checkpoint_file.hpp"
#include "output/dataset.hpp"
#include "solver/cell_sums.hpp"
#include "solver/simulation.hpp"

namespace riffle::inline solver {

/// Time means of a three-dimensional flow in cells, window by window: `/mean_field` of the results. Each
/// particle counts in one cell, those above the highest or below the lowest cell in that one, so that none is
/// lost.
class MeanField {
  public:
    explicit MeanField(const Case& c);

    /// Whether the case asks for it.
    [[nodiscard]] bool on() const { return interval_ > 0.0; }

    /// Add the particles of one instant to the present window; finishes it when its end has passed.
    void sample(const SimulationIn<3>& simulation);

    /// Centres of the cells, m.
    [[nodiscard]] std::vector<double> centres(std::size_t axis) const;
    /// Edges of the cells, m.
    [[nodiscard]] std::vector<double> edges(std::size_t axis) const;
    [[nodiscard]] std::size_t cells() const { return count_[0] * count_[1] * count_[2]; }
    /// Sums of the present window.
    [[nodiscard]] const CellSums& sums() const { return sums_; }
    [[nodiscard]] const CellPlace& count() const { return count_; }
    [[nodiscard]] double samples() const { return samples_; }
    /// Ends of the windows finished so far, s.
    [[nodiscard]] const std::vector<double>& window_ends() const { return ends_; }

    /// Bytes of a window's rows, and of those not yet taken.
    [[nodiscard]] std::size_t row_bytes() const;
    [[nodiscard]] std::size_t pending_bytes() const;
    /// Whether the newest window is complete and not yet taken: it then costs no memory beside the sums until
    /// the next sample.
    [[nodiscard]] bool has_closed_window() const { return closed_ && !closed_taken_; }
    /// The windows finished since the last call, as rows for the results file; to be written before the next
    /// sample, for the newest one is made from its sums while it is written.
    [[nodiscard]] Content take_new_rows();
    /// Number of rows of each appended dataset at the last take_new_rows(), for the checkpoint.
    void add_rows(std::map<std::string, std::size_t>& rows) const;

    void save(Content& checkpoint) const;
    void restore(const CheckpointReader& checkpoint);

    /// Names of the fields of a window, in the order of the file.
    [[nodiscard]] static std::vector<std::string> field_names();

  private:
    /// Begin the window after a closed one, whose rows are kept if nobody has taken them.
    void open_window();
    /// The rows of the closed window as arrays.
    void keep_closed_window();
    /// Values of a field in the closed window, from the place numbered `first` on in the order of the file.
    void fill(std::size_t field, std::size_t first, std::span<float> values) const;
    [[nodiscard]] CellPlace cell_of(const Particles<3>& particles, std::size_t particle) const;

    double interval_ = 0.0;
    bool open_ends_ = false;        ///< water beyond them counts in no cell
    CellPlace count_{};             ///< cells along each axis
    std::array<double, 3> edge_{};  ///< of a cell, m
    CellSums sums_;
    double samples_ = 0.0;
    double window_end_ = 0.0;
    bool closed_ = false;  ///< the sums are those of a window that has ended
    bool closed_taken_ = false;
    std::vector<double> ends_;
    std::size_t taken_ = 0;
    std::vector<double> new_samples_;
    std::vector<std::vector<float>> new_fields_;  ///< by field: rows not yet taken
    std::vector<std::uint32_t> order_;            ///< of the particles, by slices of cells across the channel
};

}  // namespace riffle::inline solver
