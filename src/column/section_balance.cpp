#include "column/section_balance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/bed_friction.hpp"
#include "case/bed_patch.hpp"
#include "case/patch_range.hpp"
#include "roughness/bed_drag.hpp"
#include "roughness/side_wall_partition.hpp"
#include "turbulence/closure.hpp"
#include "turbulence/czernuszenko_rylov.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline column {

namespace {

/// What stands beyond the last centre of a row of cells.
enum class End {
    open,    ///< no flux, where the mixing length fades: the gradient goes on as it is
    mirror,  ///< a plane of symmetry: the gradient vanishes
    rest,    ///< a wall at rest
};

/// Weights of the gradient at the centre i on the values at i - 1, i, i + 1: the mean of those at its faces.
std::array<double, 3> gradient_weights(const std::vector<double>& centre, const std::vector<double>& face,
                                       std::size_t i, End first, End last) {
    const bool has_below = i > 0;
    const bool has_above = i + 1 < centre.size();
    const double below = has_below ? 1.0 / (centre[i] - centre[i - 1]) : 0.0;
    const double above = has_above ? 1.0 / (centre[i + 1] - centre[i]) : 0.0;
    if (!has_below) {
        if (first == End::open) return {0.0, -above, above};
        const double wall = first == End::rest ? 1.0 / (centre[i] - face[i]) : 0.0;
        return {0.0, 0.5 * (wall - above), 0.5 * above};
    }
    if (!has_above) {
        if (last == End::open) return {-below, below, 0.0};
        return {-0.5 * below, 0.5 * below, 0.0};
    }
    return {-0.5 * below, 0.5 * (below - above), 0.5 * above};
}

/// The closure of a case over its bed. A bed by a wall law carries the part of the weight that the side walls
/// leave it, which counts in its viscous layer.
std::unique_ptr<const Closure> section_closure(const Case& c) {
    if (!has_wall_law(c) || !c.has_side_wall_drag()) return make_closure(c);
    const Case bed = with_fixed_roughness(c);
    return make_wall_closure(bed, *bed_wall_law(bed, std::sqrt(side_wall_partition(c).bed_stress)));
}

}  // namespace

SectionBalance::SectionBalance(const Case& c, const SectionGrid& grid)
    : columns_(grid.columns()),
      rows_(grid.rows()),
      weight_(c.streamwise_gravity()),
      viscosity_(c.fluid.kinematic_viscosity),
      rests_beside_(is_no_slip(c.bed)),
      wall_form_(c.side_walls.drag_form) {
    const auto size = static_cast<Eigen::Index>(grid.size());
    area_.resize(size);
    bed_drag_ = Eigen::VectorXd::Zero(size);
    layer_area_ = Eigen::VectorXd::Zero(size);
    std::vector<double> drag(rows_, 0.0);
    if (const auto bed = make_bed_drag(c)) bed->coefficients(grid.z, drag);
    const double layer = wall_form_ == SideDragForm::none ? 0.0 : c.side_layer();
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        for (std::size_t iy = 0; iy < columns_; ++iy) {
            const auto i = static_cast<Eigen::Index>(grid.cell(iy, iz));
            area_(i) = (grid.y_face[iy + 1] - grid.y_face[iy]) * (grid.z_face[iz + 1] - grid.z_face[iz]);
            bed_drag_(i) = area_(i) * drag[iz];
            if (grid.y[iy] < layer) layer_area_(i) = area_(i);
        }
    }
    for (std::size_t iy = 0; iy < columns_; ++iy) {
        bed_extent_.push_back(grid.y_face[iy + 1] - grid.y_face[iy]);
    }
    for (std::size_t iz = 0; iz < rows_; ++iz) wall_extent_.push_back(grid.z_face[iz + 1] - grid.z_face[iz]);
    bed_distance_ = grid.z.front() - grid.z_face.front();
    wall_distance_ = grid.y.front() - grid.y_face.front();
    if (wall_form_ == SideDragForm::consistent) {
        // Half of the section has half of the bed and one wall.
        wall_over_bed_ = 2.0 * side_wall_partition(c).wall_over_bed;
    } else if (wall_form_ == SideDragForm::thesis) {
        fixed_coefficient_ = printed_side_wall_coefficient(c);
    } else if (wall_form_ == SideDragForm::log_law) {
        wall_friction_ = side_wall_friction(c);
    }
    layer_extent_ = layer_area_.sum();
    add_vegetation(c, grid);
    add_bed_patches(c, grid);
    add_faces(c, grid);
    add_porous(c, grid);
}

void SectionBalance::add_vegetation(const Case& c, const SectionGrid& grid) {
    patches_ = vegetation_patches(c);
    patch_of_.assign(columns_, 0);
    stem_area_ = Eigen::VectorXd::Zero(area_.size());
    for (std::size_t n = 0; n < patches_.size(); ++n) {
        for (std::size_t iy = 0; iy < columns_; ++iy) {
            // The edges of the patches are faces of the grid.
            if (patches_[n].across().share(grid.y[iy], 0.5 * (grid.y_face[iy + 1] - grid.y_face[iy])) < 0.5) {
                continue;
            }
            patch_of_[iy] = n + 1;
            for (std::size_t iz = 0; iz < rows_; ++iz) {
                const double height = grid.z_face[iz + 1] - grid.z_face[iz];
                const auto i = static_cast<Eigen::Index>(grid.cell(iy, iz));
                stem_area_(i) = area_(i) * patches_[n].share_below_top(grid.z[iz], height);
            }
        }
    }
}

void SectionBalance::add_bed_patches(const Case& c, const SectionGrid& grid) {
    rests_below_.assign(columns_, rests_at_bed(c));
    for (std::size_t n = 0; n < c.bed_patches.size(); ++n) {
        const PatchRange across = ranges_of(c, c.bed_patches[n])[1];
        for (std::size_t iy = 0; iy < columns_; ++iy) {
            // The edges of the patches are faces of the grid.
            if (grid.y[iy] > across.from && grid.y[iy] < across.to) {
                patch_of_[iy] = 1 + patches_.size() + n;
                rests_below_[iy] = rests_at_bed(with_bed_of(c, c.bed_patches[n]));
            }
        }
    }
}

void SectionBalance::add_faces(const Case& c, const SectionGrid& grid) {
    const std::size_t kinds = 1 + patches_.size() + c.bed_patches.size();
    std::vector<std::vector<double>> face_length(kinds, std::vector<double>(rows_ + 1, 0.0));
    std::vector<double> face_factor(columns_ + 1, 1.0);
    cell_length_.assign(kinds, std::vector<double>(rows_, 0.0));
    cell_factor_.assign(columns_, 1.0);
    double lateral_weight = 1.0;
    if (const auto closure = section_closure(c)) {
        closure->mixing_lengths(grid.z_face, face_length[0]);
        closure->mixing_lengths(grid.z, cell_length_[0]);
        const auto set_lengths = [&](const Closure& of, std::size_t kind) {
            of.mixing_lengths(grid.z_face, face_length[kind]);
            of.mixing_lengths(grid.z, cell_length_[kind]);
        };
        for (std::size_t n = 0; n < patches_.size(); ++n) {
            set_lengths(*make_canopy_closure(c, c.vegetation[n], section_closure(c)), 1 + n);
        }
        for (std::size_t n = 0; n < c.bed_patches.size(); ++n) {
            set_lengths(*section_closure(with_bed_of(c, c.bed_patches[n])), 1 + patches_.size() + n);
        }
        for (std::size_t i = 0; i <= columns_; ++i) face_factor[i] = closure->side_factor(grid.y_face[i]);
        for (std::size_t i = 0; i < columns_; ++i) cell_factor_[i] = closure->side_factor(grid.y[i]);
        lateral_weight = stress_weight(false, true, closure->spanwise_ratio());
    }
    const auto square = [](double x) { return x * x; };
    for (std::size_t iy = 0; iy < columns_; ++iy) {
        // Stems stand on the bed of the channel.
        const std::size_t kind = patch_of_[iy] > patches_.size() ? patch_of_[iy] : 0;
        bed_length_squared_.push_back(square(face_length[kind].front()));
    }
    const auto neighbours = [&](Face& face, std::size_t side, std::size_t cell, std::size_t step, bool first,
                                bool last, const std::array<double, 3>& weights, double share) {
        const std::size_t at = 3 * side;
        face.cells[at] = static_cast<Eigen::Index>(first ? cell : cell - step);
        face.cells[at + 1] = static_cast<Eigen::Index>(cell);
        face.cells[at + 2] = static_cast<Eigen::Index>(last ? cell : cell + step);
        for (std::size_t k = 0; k < 3; ++k) face.weights[at + k] = share * weights[k];
    };
    for (std::size_t iz = 0; iz + 1 < rows_; ++iz) {
        const double low = grid.z_face[iz + 1] - grid.z_face[iz];
        const double high = grid.z_face[iz + 2] - grid.z_face[iz + 1];
        for (std::size_t iy = 0; iy < columns_; ++iy) {
            const std::array<double, 3> weights =
                gradient_weights(grid.y, grid.y_face, iy, rests_beside_ ? End::rest : End::open, End::mirror);
            Face face{};
            const bool first = iy == 0;
            const bool last = iy + 1 == columns_;
            neighbours(face, 0, grid.cell(iy, iz), 1, first, last, weights, high / (low + high));
            neighbours(face, 1, grid.cell(iy, iz + 1), 1, first, last, weights, low / (low + high));
            face.inverse_distance = 1.0 / (grid.z[iz + 1] - grid.z[iz]);
            face.length_squared = square(face_length[patch_of_[iy]][iz + 1] * cell_factor_[iy]);
            face.stress_weight = 1.0;
            face.viscosity_ratio = 1.0;
            face.extent = bed_extent_[iy];
            vertical_faces_.push_back(face);
        }
    }
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        const auto weights_over = [&](std::size_t iy) {
            return gradient_weights(grid.z, grid.z_face, iz, rests_below_[iy] ? End::rest : End::open,
                                    End::open);
        };
        for (std::size_t iy = 0; iy + 1 < columns_; ++iy) {
            Face face{};
            const bool first = iz == 0;
            const bool last = iz + 1 == rows_;
            const double both = bed_extent_[iy] + bed_extent_[iy + 1];
            neighbours(face, 0, grid.cell(iy, iz), columns_, first, last, weights_over(iy),
                       bed_extent_[iy + 1] / both);
            neighbours(face, 1, grid.cell(iy + 1, iz), columns_, first, last, weights_over(iy + 1),
                       bed_extent_[iy] / both);
            face.inverse_distance = 1.0 / (grid.y[iy + 1] - grid.y[iy]);
            const double length =
                0.5 * (cell_length_[patch_of_[iy]][iz] + cell_length_[patch_of_[iy + 1]][iz]);
            face.length_squared = square(length * face_factor[iy + 1]);
            face.stress_weight = lateral_weight;
            face.viscosity_ratio = 1.0;
            face.extent = grid.z_face[iz + 1] - grid.z_face[iz];
            lateral_faces_.push_back(face);
        }
    }
}

void SectionBalance::add_porous(const Case& c, const SectionGrid& grid) {
    const PorousMedia porous(c);
    if (porous.empty()) return;
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        for (std::size_t iy = 0; iy < columns_; ++iy) {
            media_.push_back(porous.at(0.0, grid.y[iy], grid.z[iz]));
            const double length = cell_length_[patch_of_[iy]][iz] * cell_factor_[iy];
            pore_length_.push_back(porous.limited(length, 0.0, grid.y[iy], grid.z[iz]));
            const auto i = static_cast<Eigen::Index>(grid.cell(iy, iz));
            bed_drag_(i) /= media_.back().porosity;
            layer_area_(i) /= media_.back().porosity;
        }
    }
    const auto change = [&](Face& face, double y, double z) {
        face.viscosity_ratio = porous.at(0.0, y, z).viscosity_ratio;
        const double length = porous.limited(std::sqrt(face.length_squared), 0.0, y, z);
        face.length_squared = length * length;
    };
    std::size_t k = 0;
    for (std::size_t iz = 0; iz + 1 < rows_; ++iz) {
        for (std::size_t iy = 0; iy < columns_; ++iy) {
            change(vertical_faces_[k++], grid.y[iy], grid.z_face[iz + 1]);
        }
    }
    k = 0;
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        for (std::size_t iy = 0; iy + 1 < columns_; ++iy) {
            change(lateral_faces_[k++], grid.y_face[iy + 1], grid.z[iz]);
        }
    }
    for (std::size_t iy = 0; iy < columns_; ++iy) {
        const double at_bed = porous.limited(std::sqrt(bed_length_squared_[iy]), 0.0, grid.y[iy], 0.0);
        bed_length_squared_[iy] = at_bed * at_bed;
    }
}

Eigen::VectorXd SectionBalance::water_area() const {
    Eigen::VectorXd water = area_;
    for (Eigen::Index i = 0; i < water.size(); ++i) water(i) *= porosity(i);
    return water;
}

double SectionBalance::porous_force(const Eigen::VectorXd& u) const {
    double force = 0.0;
    for (Eigen::Index i = 0; !media_.empty() && i < u.size(); ++i) {
        const PorousMedia::At& at = media_[static_cast<std::size_t>(i)];
        force += area_(i) * at.along(std::abs(u(i))) * u(i);
    }
    return force;
}

SectionBalance::FaceFlow SectionBalance::flow(const Face& face, const Eigen::VectorXd& u) const {
    const double normal = (u(face.plus()) - u(face.minus())) * face.inverse_distance;
    double tangent = 0.0;
    for (std::size_t k = 0; k < 6; ++k) tangent += face.weights[k] * u(face.cells[k]);
    const double rate = std::hypot(normal, tangent);
    const double factor = face.stress_weight * face.length_squared;
    const double steepening = rate > 0.0 ? factor * normal / rate : 0.0;
    const double viscosity = viscosity_ + factor * rate;
    const double ratio = face.viscosity_ratio;
    return {ratio * (viscosity * normal), ratio * (viscosity + steepening * normal),
            ratio * (steepening * tangent)};
}

SectionBalance::FaceFlow SectionBalance::bed_flow(std::size_t iy, const Eigen::VectorXd& u) const {
    if (!rests_below_[iy]) {
        return {};
    }
    const double gradient = u(static_cast<Eigen::Index>(iy)) / bed_distance_;
    const double factor = bed_length_squared_[iy] * cell_factor_[iy] * cell_factor_[iy];
    const double rate = std::abs(gradient);
    const double ratio = media_.empty() ? 1.0 : media_[iy].viscosity_ratio;
    return {ratio * (viscosity_ + factor * rate) * gradient, ratio * (viscosity_ + 2.0 * factor * rate), 0.0};
}

double SectionBalance::wall_slope(std::size_t iz) const {
    if (!rests_beside_) return 0.0;
    const double ratio = media_.empty() ? 1.0 : media_[iz * columns_].viscosity_ratio;
    return ratio * viscosity_ / wall_distance_;
}

double SectionBalance::layer_sum(const Eigen::VectorXd& u) const {
    return (layer_area_.array() * u.array() * u.array().abs()).sum();
}

double SectionBalance::bed_force(const Eigen::VectorXd& u) const {
    double force = (bed_drag_.array() * u.array() * u.array().abs()).sum();
    for (std::size_t iy = 0; iy < columns_; ++iy) force += bed_extent_[iy] * bed_flow(iy, u).stress;
    return force;
}

double SectionBalance::wall_coefficient(const Eigen::VectorXd& u) const {
    const double layer = layer_sum(u);
    if (wall_friction_) return wall_friction_->coefficient(layer / layer_extent_);
    if (wall_form_ != SideDragForm::consistent) return fixed_coefficient_;
    // Water at rest: the limit of a uniform velocity.
    if (!(layer > 0.0)) return wall_over_bed_ * bed_drag_.sum() / layer_area_.sum();
    return wall_over_bed_ * bed_force(u) / layer;
}

double SectionBalance::wall_force(const Eigen::VectorXd& u) const {
    double force = wall_coefficient(u) * layer_sum(u);
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        force += wall_extent_[iz] * wall_slope(iz) * u(static_cast<Eigen::Index>(iz * columns_));
    }
    return force;
}

double SectionBalance::vegetation_force(const Eigen::VectorXd& u) const {
    double force = 0.0;
    for (Eigen::Index i = 0; !patches_.empty() && i < u.size(); ++i) {
        if (stem_area_(i) > 0.0) force += stem_area_(i) * stems_in(i).deceleration(u(i));
    }
    return force;
}

const StemDrag& SectionBalance::stems_in(Eigen::Index cell) const {
    return patches_[patch_of_[static_cast<std::size_t>(cell) % columns_] - 1].drag();
}

Eigen::VectorXd SectionBalance::residual(const Eigen::VectorXd& u) const {
    Eigen::VectorXd force =
        weight_ * area_.array() -
        (bed_drag_.array() + wall_coefficient(u) * layer_area_.array()) * u.array() * u.array().abs();
    for (Eigen::Index i = 0; !patches_.empty() && i < u.size(); ++i) {
        if (stem_area_(i) > 0.0) force(i) -= stem_area_(i) * stems_in(i).deceleration(u(i));
    }
    for (Eigen::Index i = 0; !media_.empty() && i < u.size(); ++i) {
        const PorousMedia::At& at = media_[static_cast<std::size_t>(i)];
        force(i) -= area_(i) * ((1.0 - at.porosity) * weight_ + at.along(std::abs(u(i))) * u(i));
    }
    for (const auto* faces : {&vertical_faces_, &lateral_faces_}) {
        for (const Face& face : *faces) {
            const double exchange = face.extent * flow(face, u).stress;
            force(face.minus()) += exchange;
            force(face.plus()) -= exchange;
        }
    }
    for (std::size_t iy = 0; iy < columns_; ++iy) {
        force(static_cast<Eigen::Index>(iy)) -= bed_extent_[iy] * bed_flow(iy, u).stress;
    }
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        const auto i = static_cast<Eigen::Index>(iz * columns_);
        force(i) -= wall_extent_[iz] * wall_slope(iz) * u(i);
    }
    return force;
}

SectionJacobian SectionBalance::jacobian(const Eigen::VectorXd& u) const {
    const Eigen::Index n = u.size();
    const double wall = wall_coefficient(u);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * (vertical_faces_.size() + lateral_faces_.size()) + 2 * static_cast<std::size_t>(n));
    for (Eigen::Index i = 0; i < n; ++i) {
        entries.emplace_back(i, i, 2.0 * std::abs(u(i)) * (bed_drag_(i) + wall * layer_area_(i)));
        if (stem_area_(i) > 0.0) {
            entries.emplace_back(i, i, stem_area_(i) * stems_in(i).deceleration_slope(u(i)));
        }
        if (!media_.empty()) {
            const PorousMedia::At& at = media_[static_cast<std::size_t>(i)];
            entries.emplace_back(i, i, area_(i) * at.along(2.0 * std::abs(u(i))));
        }
    }
    for (const auto* faces : {&vertical_faces_, &lateral_faces_}) {
        for (const Face& face : *faces) {
            const FaceFlow f = flow(face, u);
            std::array<double, 6> slope{};
            for (std::size_t k = 0; k < 6; ++k) slope[k] = f.tangent_slope * face.weights[k];
            slope[1] -= f.normal_slope * face.inverse_distance;
            slope[4] += f.normal_slope * face.inverse_distance;
            for (std::size_t k = 0; k < 6; ++k) {
                entries.emplace_back(face.minus(), face.cells[k], -face.extent * slope[k]);
                entries.emplace_back(face.plus(), face.cells[k], face.extent * slope[k]);
            }
        }
    }
    Eigen::VectorXd bed_slope = 2.0 * bed_drag_.array() * u.array().abs();
    for (std::size_t iy = 0; iy < columns_; ++iy) {
        const auto i = static_cast<Eigen::Index>(iy);
        const double slope = bed_extent_[iy] * bed_flow(iy, u).normal_slope / bed_distance_;
        entries.emplace_back(i, i, slope);
        bed_slope(i) += slope;
    }
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        const auto i = static_cast<Eigen::Index>(iz * columns_);
        entries.emplace_back(i, i, wall_extent_[iz] * wall_slope(iz));
    }
    SectionJacobian result;
    result.matrix.resize(n, n);
    result.matrix.setFromTriplets(entries.begin(), entries.end());
    result.column = layer_area_.array() * u.array() * u.array().abs();
    result.row = Eigen::VectorXd::Zero(n);
    const double layer = result.column.sum();
    if (wall_form_ == SideDragForm::consistent && layer > 0.0) {
        result.row =
            (wall_over_bed_ * bed_slope.array() - wall * 2.0 * layer_area_.array() * u.array().abs()) / layer;
    }
    if (wall_friction_) {
        result.row = (wall_friction_->slope(layer / layer_extent_) / layer_extent_) * 2.0 *
                     layer_area_.array() * u.array().abs();
    }
    return result;
}

SectionBalance::Stresses SectionBalance::stresses(const Eigen::VectorXd& u) const {
    Stresses result{std::vector<double>(rows_ * columns_, 0.0), std::vector<double>(rows_ * columns_, 0.0)};
    // The mean of the faces of a cell; those at the ends of the section carry none.
    const auto share = [](std::vector<double>& cells, const Face& face, double stress) {
        cells[static_cast<std::size_t>(face.minus())] += 0.5 * stress;
        cells[static_cast<std::size_t>(face.plus())] += 0.5 * stress;
    };
    for (const Face& face : vertical_faces_) share(result.vertical, face, flow(face, u).stress);
    for (const Face& face : lateral_faces_) share(result.lateral, face, flow(face, u).stress);
    for (std::size_t iy = 0; iy < columns_; ++iy) result.vertical[iy] += 0.5 * bed_flow(iy, u).stress;
    for (std::size_t iz = 0; iz < rows_; ++iz) {
        const std::size_t i = iz * columns_;
        result.lateral[i] += 0.5 * wall_slope(iz) * u(static_cast<Eigen::Index>(i));
    }
    return result;
}

bool SectionBalance::has_friction() const {
    const bool porous = std::any_of(media_.begin(), media_.end(),
                                    [](const PorousMedia::At& at) { return at.along(1.0) > 0.0; });
    const bool rests = std::any_of(rests_below_.begin(), rests_below_.end(), [](bool at) { return at; });
    return rests || bed_drag_.sum() > 0.0 || stem_area_.sum() > 0.0 || porous || wall_friction_ ||
           fixed_coefficient_ * layer_area_.sum() > 0.0;
}

}  // namespace riffle::inline column
