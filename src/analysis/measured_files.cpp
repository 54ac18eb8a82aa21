#include "analysis/measured_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "laboratory/csv_table.hpp"

namespace riffle::inline analysis {

namespace {

bool varies(const CsvTable& table, char axis) {
    for (const CsvColumn& column : table.columns) {
        if (column.name.size() != 1 || (column.name[0] | 0x20) != axis) continue;
        return std::any_of(column.values.begin(), column.values.end(),
                           [&](double value) { return value != column.values.front(); });
    }
    return false;
}

/// Mean of finite values; not-a-number without any.
class Mean {
  public:
    void add(double value) {
        if (!std::isfinite(value)) return;
        sum_ += value;
        count_ += 1.0;
    }
    [[nodiscard]] double value() const { return count_ > 0.0 ? sum_ / count_ : not_a_number; }
    [[nodiscard]] double count() const { return count_; }

  private:
    double sum_ = 0.0;
    double count_ = 0.0;
};

}  // namespace

LaboratoryKind laboratory_kind(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return LaboratoryKind::field;
    const CsvTable table = read_field_table(path);
    if (is_velocity_field(table)) return LaboratoryKind::field;
    const auto has = [&](const char* name) {
        return std::any_of(table.columns.begin(), table.columns.end(),
                           [&](const CsvColumn& column) { return column.name == name; });
    };
    if (varies(table, 'y')) return LaboratoryKind::section;
    if (has_position(table, 'z') || table.header_line == 0) return LaboratoryKind::profile;
    if (has("u") || has("U")) return LaboratoryKind::velocity;
    return LaboratoryKind::waves;
}

Profiles profiles_of(const ProfileRecord& record, double datum, double density) {
    const auto values = [&](ProfileQuantity quantity) {
        const ProfileColumn* const found = record.find(quantity);
        return found == nullptr ? std::vector<double>{} : found->values;
    };
    const std::vector<double> u = values(ProfileQuantity::velocity);
    if (u.empty()) {
        throw FileError(record.source.string() + ": the profile has no column u (streamwise velocity)");
    }
    // Points without u belong to no profile of it.
    const auto keep = [&](const std::vector<double>& all) {
        std::vector<double> kept;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (std::isfinite(u[i])) kept.push_back(all[i]);
        }
        return kept;
    };
    Profiles p;
    p.velocity = keep(u);
    for (const double z : keep(record.z)) p.z.push_back(z + datum);
    for (const double each : keep(record.find(ProfileQuantity::velocity)->uncertainty)) {
        p.velocity_half_width.push_back(normal_95 * each);
    }
    p.velocity_rms = keep(values(ProfileQuantity::streamwise_rms));
    p.vertical_velocity = keep(values(ProfileQuantity::vertical_velocity));
    p.vertical_velocity_rms = keep(values(ProfileQuantity::vertical_rms));
    p.spanwise_velocity_rms = keep(values(ProfileQuantity::spanwise_rms));
    p.velocity_gradient = keep(values(ProfileQuantity::velocity_gradient));
    for (const double stress : keep(values(ProfileQuantity::reynolds_stress))) {
        p.reynolds_stress.push_back(density * stress);
    }
    p.bin_upper = p.z;
    return p;
}

VelocityGrid grid_of(const VelocityField& field, double datum) {
    VelocityGrid grid;
    grid.name = field.title.empty() ? field.source.stem().string() : field.title;
    grid.x = field.x;
    for (const double z : field.z) grid.z.push_back(z + datum);
    const std::size_t points = field.points();
    for (std::size_t i = 0; i < points; ++i) {
        Mean u;
        Mean w;
        Mean uu;
        Mean ww;
        Mean uw;
        for (std::size_t k = 0; k < field.frames; ++k) {
            const double a = field.u[k * points + i];
            const double b = field.w[k * points + i];
            if (!std::isfinite(a) || !std::isfinite(b)) continue;
            u.add(a);
            w.add(b);
            uu.add(a * a);
            ww.add(b * b);
            uw.add(a * b);
        }
        grid.u.push_back(u.value());
        grid.w.push_back(w.value());
        if (field.frames < 2) continue;
        grid.uu.push_back(uu.value() - u.value() * u.value());
        grid.ww.push_back(ww.value() - w.value() * w.value());
        grid.uw.push_back(uw.value() - u.value() * w.value());
    }
    grid.uncertainty = field.u_uncertainty;
    return grid;
}

VelocityPlane plane_of(const VelocityField& field, double datum) {
    VelocityPlane plane;
    if (field.time.empty()) return plane;
    plane.name = field.title.empty() ? field.source.stem().string() : field.title;
    plane.x = field.x;
    for (const double z : field.z) plane.z.push_back(z + datum);
    plane.time = field.time;
    plane.u = field.u;
    plane.w = field.w;
    return plane;
}

Profiles profiles_of(const VelocityGrid& grid, double density) {
    Profiles p;
    for (std::size_t j = 0; j < grid.z.size(); ++j) {
        const auto along = [&](const std::vector<double>& values) {
            Mean mean;
            for (std::size_t i = 0; i < grid.x.size() && !values.empty(); ++i) {
                mean.add(values[j * grid.x.size() + i]);
            }
            return mean;
        };
        const Mean u = along(grid.u);
        // A row of which less than half of the vectors were found is that of the surface or of reflections.
        if (2.0 * u.count() < static_cast<double>(grid.x.size())) continue;
        p.z.push_back(grid.z[j]);
        p.velocity.push_back(u.value());
        p.vertical_velocity.push_back(along(grid.w).value());
        if (!grid.uncertainty.empty()) {
            // Neighbouring vectors overlap, and calibration errors are common to all: not divided by their
            // number.
            p.velocity_half_width.push_back(normal_95 * along(grid.uncertainty).value());
        }
        if (grid.uu.empty()) continue;
        p.velocity_rms.push_back(std::sqrt(std::max(0.0, along(grid.uu).value())));
        p.vertical_velocity_rms.push_back(std::sqrt(std::max(0.0, along(grid.ww).value())));
        p.reynolds_stress.push_back(-density * along(grid.uw).value());
    }
    p.bin_upper = p.z;
    return p;
}

void add_measured_file(const std::filesystem::path& path, const Case& c, FlowRecord::Measured& measured,
                       std::vector<std::string>& warnings) {
    const auto warn = [&](const std::vector<std::string>& more) {
        for (const std::string& warning : more) warnings.push_back(path.filename().string() + ": " + warning);
    };
    const auto take_profile = [&](const Profiles& p) {
        measured.profile = {p.z, p.velocity, {}};
        for (const double half_width : p.velocity_half_width) {
            measured.profile.uncertainty.push_back(half_width / normal_95);
        }
        measured.from_law = false;
        measured.note.clear();
        measured.turbulence = p;
        measured.file.reset();
    };
    switch (laboratory_kind(path)) {
        case LaboratoryKind::profile: {
            if (measured.file) {
                warnings.push_back(fmt::format(
                    "{}: the flow is compared with one measured profile, and this file was named after {}, "
                    "which is left out",
                    path.filename().string(), measured.file->source.filename().string()));
            }
            Case with = c;
            with.measured.velocity_profile = path;
            measured.profile =
                read_velocity_measurements(with);  // which checks that the points lie in the water
            measured.from_law = false;
            measured.note.clear();
            const ProfileRecord record = read_profile_record(path);
            measured.turbulence = profiles_of(record, c.datum(), c.fluid.density);
            warn(record.warnings);
            measured.file = record;
            return;
        }
        case LaboratoryKind::section: {
            const SectionRecord record = read_section_record(path);
            measured.section = section_points_of(record, c);
            warn(record.warnings);
            return;
        }
        case LaboratoryKind::field: {
            const VelocityField field = read_velocity_field(path);
            measured.field = grid_of(field, c.datum());
            // A profile of its own counts more than the means of a field, in whatever order they are named.
            if (!measured.file) take_profile(profiles_of(measured.field, c.fluid.density));
            warn(field.warnings);
            return;
        }
        case LaboratoryKind::velocity:
        case LaboratoryKind::waves:
            throw FileError(
                path.string() +
                ": --measured takes time means: a profile (column z), points of a cross-section (y) or a "
                "field of velocities (x, z, u, w); records over time are analysed by naming them as inputs");
    }
}

}  // namespace riffle::inline analysis
