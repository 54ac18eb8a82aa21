#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "boundary/free_body.hpp"
#include "boundary/wall_motion.hpp"
#include "case/case.hpp"
#include "instruments/fluid_view.hpp"
#include "particles/force_on_solid.hpp"
#include "particles/sparse_values.hpp"
#include "record/field.hpp"

namespace riffle::inline instruments {

/// The state after a step, for instruments.
struct FlowState {
    double time = 0.0;                  ///< s
    double streamwise_gravity = 0.0;    ///< m/s2
    std::span<const double> mass = {};  ///< by particle, kg; in two dimensions per width, kg/m
    std::span<const double> x = {};     ///< by particle, distance along the channel, m
    const FluidView* fluid = nullptr;   ///< where an instrument `looks_at_fluid`
    /// Where an instrument `needs_fields`, by particle: accelerations, m/s2, those of the side walls' drag in
    /// three dimensions only; pressure, Pa; stress tau_xz of viscosity and closure, Pa.
    const SparseValues* drag_x = nullptr;
    const SparseValues* wall_x = nullptr;
    const SparseValues* wall_z = nullptr;
    const SparseValues* side_wall_x = nullptr;
    const SparseValues* vegetation_x = nullptr;  ///< of the stems, where there are any
    const SparseValues* porous_x = nullptr;      ///< of the resistance of porous zones, where there are any
    const WorkingValues* pressure = nullptr;
    std::span<const double> shear_stress = {};
    std::span<const ForceOnSolid> solids = {};        ///< so, by solid
    std::span<const BodyState> bodies = {};           ///< by body; empty where there are no solids
    std::span<const FreeBodyState> free_bodies = {};  ///< of the free ones
};

/// An array that an instrument fills: one row per sample, or per averaging window.
struct InstrumentRecord {
    std::string name;
    std::string unit;
    std::string long_name;
    std::vector<std::size_t> row_shape;  ///< empty: one number
    std::variant<std::vector<float>, std::vector<double>> values;

    /// Bytes of a row.
    [[nodiscard]] std::size_t row_bytes() const;
    /// Add a number to the row that is being made.
    void add(double value);
};

/// An array that stays as it is: positions.
struct InstrumentAxis {
    std::string name;
    std::string unit;
    std::string long_name;
    std::vector<double> values;
};

/// An instrument: what it samples becomes rows of its records, kept until they are taken. A new kind is a
/// file with a class of this base and a line in make_instrument (instrument.cpp).
class Instrument {
  public:
    virtual ~Instrument() = default;

    /// Take one sample; adds a row, or part of one that is averaged.
    virtual void sample(const FlowState& state) = 0;

    /// Whether sample() uses FlowState::fluid, and the fields by particle.
    [[nodiscard]] virtual bool looks_at_fluid() const { return true; }
    [[nodiscard]] virtual bool needs_fields() const { return false; }

    /// Points of a sample, for the forecast.
    [[nodiscard]] virtual std::size_t points() const = 0;
    /// Rows per simulated time, 1/s.
    [[nodiscard]] virtual double row_frequency() const { return probe_.sampling_frequency; }

    /// What an unfinished row needs to be gone on with, for the checkpoint.
    [[nodiscard]] virtual std::vector<double> unfinished() const { return {}; }
    virtual void restore_unfinished(const std::vector<double>& /*saved*/) {}

    [[nodiscard]] const Probe& probe() const { return probe_; }
    [[nodiscard]] const std::vector<InstrumentAxis>& axes() const { return axes_; }
    [[nodiscard]] const std::vector<InstrumentRecord>& records() const { return records_; }
    /// Bytes of a row of all records.
    [[nodiscard]] std::size_t row_bytes() const;
    /// Rows not yet taken.
    [[nodiscard]] std::size_t rows() const { return rows_; }
    /// The records with these rows, which are then forgotten here.
    [[nodiscard]] std::vector<InstrumentRecord> take();

  protected:
    Instrument(Probe probe, const Case& c) : probe_(std::move(probe)), dimensions_(c.channel.dimensions) {}

    /// Declare arrays, in the constructor; those of fields that only runs in three dimensions have are left
    /// out in two. The first record of every instrument is its time, in double precision as forces are.
    void add_axis(const Field& field, std::vector<double> values);
    void add_record(const Field& field, std::vector<std::size_t> row_shape, bool in_double = false);
    /// A record of a solid, which its name and its meaning name. `number`: of the solid, from 1.
    void add_record_of_solid(const Field& field, std::size_t number, const std::string& solid);

    [[nodiscard]] InstrumentRecord& record(std::size_t index) { return records_[index]; }
    /// To be called once all records have their row.
    void end_row() { ++rows_; }

  private:
    [[nodiscard]] bool has(const Field& field) const {
        return dimensions_ == 3 || (field.written & three_dimensions) == 0U;
    }

    Probe probe_;
    int dimensions_;
    std::vector<InstrumentAxis> axes_;
    std::vector<InstrumentRecord> records_;
    std::size_t rows_ = 0;
};

/// Positions across the channel of an instrument with `points` points: its y, or the centreline.
[[nodiscard]] std::vector<double> across(const Probe& probe, const Case& c, std::size_t points);

/// Columns and rows of a grid in the x-z plane, m.
struct GridAxes {
    std::vector<double> x, z;
};
/// Those of a probe with `spacing`, `x_from` and so on: by default the whole channel, bed to still surface. A
/// periodic channel's end, which is its start, is not among them.
[[nodiscard]] GridAxes grid_axes(const Probe& probe, const Case& c);

// The instruments, one file each.
[[nodiscard]] std::unique_ptr<Instrument> make_velocity_points(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_wave_probes(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_surface_line(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_velocity_grid(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_velocity_plane(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_flow_rate_sections(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_pressure_gauges(const Probe& probe, const Case& c);
[[nodiscard]] std::unique_ptr<Instrument> make_bed_force(const Probe& probe, const Case& c);

/// The instrument of an entry of [[probe]]. The one place where a kind is registered.
[[nodiscard]] std::unique_ptr<Instrument> make_instrument(const Probe& probe, const Case& c);

}  // namespace riffle::inline instruments
