#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "instruments/instrument.hpp"
#include "output/checkpoint_file.hpp"
#include "output/dataset.hpp"

namespace riffle::inline instruments {

/// The instruments of a run, those of the case file and the standard ones: when each is due, and its rows on
/// the way to `/probes/NAME` of the results. Due times are multiples of the sampling interval and follow from
/// the simulated time alone.
class ProbeSet {
  public:
    /// `largest_step`: bound of the time step, s. Throws InputError (place, probe, limit, what to do) where
    /// an instrument samples faster than every second step.
    ProbeSet(const Case& c, double largest_step);

    /// Whether something that is due at `time` looks at the fluid.
    [[nodiscard]] bool due_for_fluid(double time) const;
    /// Whether something that is due at `time` looks at the fluid and needs the fields of the particles.
    [[nodiscard]] bool due_for_fields_in_fluid(double time) const;
    /// Time from which something is due that needs the fields of the particles.
    [[nodiscard]] double forces_due() const;

    /// Sample what is due at the state's time, of the instruments that look at the fluid or of the others.
    void record(const FlowState& state, bool looks_at_fluid);

    /// Bytes recorded since the last take_new_rows().
    [[nodiscard]] std::size_t pending_bytes() const;
    /// Rows recorded since the last call.
    [[nodiscard]] Content take_new_rows();
    /// Number of rows of each appended dataset at the last take_new_rows(), for the checkpoint.
    [[nodiscard]] std::map<std::string, std::size_t> rows() const;

    /// State for the checkpoint: due times, rows, windows being averaged.
    void save(Content& checkpoint) const;
    /// Put it back. Throws FileError where the checkpoint lacks it.
    void restore(const CheckpointReader& checkpoint);

    struct Member {
        std::unique_ptr<Instrument> instrument;
        bool standard = false;
        double due = 0.0;       ///< next sample, s
        std::size_t taken = 0;  ///< rows taken so far

        [[nodiscard]] bool is_due(double time) const;
        [[nodiscard]] double interval() const;  ///< between samples, s
    };
    [[nodiscard]] const std::vector<Member>& members() const { return members_; }
    /// What the standard set leaves out, and why.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  private:
    std::vector<Member> members_;
    std::vector<std::string> notes_;
};

/// Rows that an instrument records until `end`, s.
[[nodiscard]] double recorded_rows(const Instrument& instrument, double end);

}  // namespace riffle::inline instruments
