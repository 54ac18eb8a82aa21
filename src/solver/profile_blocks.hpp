#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"
#include "column/section.hpp"
#include "record/profiles.hpp"
#include "solver/simulation.hpp"

namespace riffle::inline solver {

/// Sums over the particles of a layer that the profiles are made of. Order of the last axis of
/// `/profile_blocks/sums`; `profile_quantity_names` has the names.
enum class LayerQuantity : std::size_t {
    count,
    height,
    u,
    w,
    uu,
    ww,
    uw,
    column_u,
    shear,
    eddy_viscosity,
    pressure,
    density,
    mass,
    pair_force,
    viscous_force,
    drag_force,
    // Three dimensions only.
    v,
    vv,
    uv,
    vw,
    side_wall_force,
    quantities
};
[[nodiscard]] constexpr std::size_t profile_quantities(int dimensions) {
    return static_cast<std::size_t>(dimensions == 2 ? LayerQuantity::v : LayerQuantity::quantities);
}
[[nodiscard]] std::span<const std::string> profile_quantity_names(int dimensions);

/// Layer sums of one block of time (profile_block_duration), over its samples.
struct ProfileBlock {
    double end = 0.0;  ///< end of the block, s
    double samples = 0.0;
    std::vector<double> sums;  ///< layers x quantities
};

/// Length of a block, s. Averages over any window of whole blocks can be made afterwards.
inline constexpr double profile_block_duration = 0.1;

/// Collects layer sums. Layers are H/round(H/dx) thick, so that each row of a layered flow has its own.
class ProfileSampler {
  public:
    /// `section`: twin of a channel with side walls; the column is then not compared with.
    ProfileSampler(const Case& c, const ColumnResult* column, const SectionResult* section = nullptr);

    /// Add the particles of one instant to the current block; closes blocks whose end has passed.
    template <int D>
    void sample(const SimulationIn<D>& simulation);

    [[nodiscard]] const std::vector<ProfileBlock>& blocks() const { return blocks_; }
    [[nodiscard]] const ProfileBlock& current() const { return current_; }
    [[nodiscard]] std::size_t layers() const { return layers_; }
    /// Sums per layer.
    [[nodiscard]] std::size_t quantities() const { return quantities_; }

    /// Put back saved blocks.
    void restore(std::vector<ProfileBlock> blocks, ProfileBlock current);

    /// Averages over the blocks that lie in [from, to]. Empty if there are none.
    [[nodiscard]] Profiles average(double from, double to) const;

  private:
    template <int D>
    void add_particles(const SimulationIn<D>& simulation, std::size_t begin, std::size_t end,
                       std::vector<double>& layer_sums) const;
    /// Momentum per plan area that a force takes from all layers above the upper edge of each: where nothing
    /// but the bed holds them the stress on the plane there, Pa. `per_area`: 1/(samples x plan area).
    [[nodiscard]] std::vector<double> lost_above(const std::vector<double>& sums, LayerQuantity force,
                                                 double per_area) const;
    /// Stress of viscosity and closure at the upper edges of the layers, Pa, by the mean velocities and eddy
    /// viscosities of the layers beside them; at a wall at the top on the line through the two edges below
    /// it.
    [[nodiscard]] std::vector<double> stress_of_means(const std::vector<double>& sums) const;

    Case case_;
    const ColumnResult* column_;
    const SectionResult* section_;
    std::size_t layers_ = 0;
    std::size_t quantities_ = 0;
    double thickness_ = 0.0;
    double plan_area_ = 0.0;  ///< of the bed, m2; in two dimensions its length, m
    std::vector<ProfileBlock> blocks_;
    ProfileBlock current_;
};

}  // namespace riffle::inline solver
