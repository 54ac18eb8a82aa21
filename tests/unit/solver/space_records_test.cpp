// What is recorded of a run in three dimensions: sums that lose no particle and depend on nothing but the
// flow.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>

#include "base/parallel.hpp"
#include "output/checkpoint_file.hpp"
#include "output/results_file.hpp"
#include "record/flow_fields.hpp"
#include "small_case.hpp"
#include "solver/mean_field.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"
#include "solver/snapshots.hpp"
#include "temporary_folder.hpp"

namespace riffle::space_records_test {
namespace {

using Space = test::ChannelIn<3>;

Case space_case() {
    Case c = test::small_channel(3);
    c.bed.drag_form = DragForm::consistent;
    c.start.jitter = 0.2;
    c.output.mean_field_interval = 1.0;
    return c;
}

/// f(cell) for each cell.
template <class F>
void for_cells(const MeanField& field, const F& f) {
    const auto [nx, ny, nz] = field.count();
    for (std::size_t x = 0; x < nx; ++x) {
        for (std::size_t y = 0; y < ny; ++y) {
            for (std::size_t z = 0; z < nz; ++z) {
                f(CellPlace{x, y, z});
            }
        }
    }
}

double sum_of(const MeanField& field, CellQuantity quantity) {
    double sum = 0.0;
    for_cells(field, [&](const CellPlace& cell) { sum += field.sums().get(cell, quantity); });
    return sum;
}

/// Sum over all samples, from the means of the cells: of a value, or of the product of two.
double total_of(const MeanField& field, CellQuantity mean) {
    double sum = 0.0;
    for_cells(field, [&](const CellPlace& cell) {
        sum += field.sums().get(cell, CellQuantity::count) * field.sums().get(cell, mean);
    });
    return sum;
}
double total_of(const MeanField& field, CellQuantity product, CellQuantity first, CellQuantity second) {
    double sum = 0.0;
    for_cells(field, [&](const CellPlace& cell) {
        const auto get = [&](CellQuantity q) { return field.sums().get(cell, q); };
        sum += get(CellQuantity::count) * (get(product) + get(first) * get(second));
    });
    return sum;
}

/// All sums of all cells.
std::vector<double> all_sums(const MeanField& field) {
    std::vector<double> sums;
    for_cells(field, [&](const CellPlace& cell) {
        for (std::size_t q = 0; q < cell_quantities; ++q) {
            sums.push_back(field.sums().get(cell, static_cast<CellQuantity>(q)));
        }
    });
    return sums;
}

double sum_of(const ProfileBlock& block, LayerQuantity quantity) {
    double sum = 0.0;
    for (std::size_t k = static_cast<std::size_t>(quantity); k < block.sums.size();
         k += profile_quantities(3)) {
        sum += block.sums[k];
    }
    return sum;
}

std::vector<float> floats(const Content& content, const std::string& path) {
    for (const Dataset& dataset : content.datasets) {
        if (dataset.path == path) {
            if (const auto* streamed = std::get_if<StreamedValues<float>>(&dataset.values)) {
                std::vector<float> values(streamed->count);
                streamed->fill(0, values);
                return values;
            }
            return std::get<std::vector<float>>(dataset.values);
        }
    }
    throw std::logic_error("no " + path);
}

TEST(MeanFieldSums, AreThoseOfTheLayersAndOfAllParticles) {
    const Case c = space_case();
    const Space channel(c);
    channel.advance(30);
    MeanField field(c);
    ProfileSampler profiles(c, &channel.column);
    field.sample(*channel.simulation);
    profiles.sample(*channel.simulation);
    const Particles<3>& p = channel.simulation->particles();
    const ProfileBlock& block = profiles.current();
    // Each particle is in one cell; sums of the same terms in another order, through means in single
    // precision.
    EXPECT_EQ(sum_of(field, CellQuantity::count), static_cast<double>(p.size()));
    EXPECT_EQ(sum_of(block, LayerQuantity::count), static_cast<double>(p.size()));
    const auto total = [&](auto value) {
        double sum = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += value(i);
        return sum;
    };
    const auto& [u, v, w] = p.velocity;
    const double scale = 1e-12 * static_cast<double>(p.size());
    const double rounding = 1e-7 * static_cast<double>(p.size());
    using Q = CellQuantity;
    EXPECT_NEAR(total_of(field, Q::u), total([&](auto i) { return u[i]; }), rounding);
    EXPECT_NEAR(total_of(field, Q::uv, Q::u, Q::v), total([&](auto i) { return u[i] * v[i]; }), rounding);
    EXPECT_NEAR(total_of(field, Q::vw, Q::v, Q::w), sum_of(block, LayerQuantity::vw), rounding);
    EXPECT_NEAR(total_of(field, Q::ww, Q::w, Q::w), sum_of(block, LayerQuantity::ww), rounding);
    EXPECT_NEAR(sum_of(field, Q::drag_force), sum_of(block, LayerQuantity::drag_force), scale);
    EXPECT_NEAR(total_of(field, Q::pressure), sum_of(block, LayerQuantity::pressure), 1e3 * rounding);
    EXPECT_GT(std::abs(sum_of(field, CellQuantity::drag_force)), 1e-4);
    // A row of cells is a layer.
    for (std::size_t layer = 0; layer < profiles.layers(); ++layer) {
        double count = 0.0;
        for_cells(field, [&](const CellPlace& cell) {
            count += cell[2] == layer ? field.sums().get(cell, CellQuantity::count) : 0.0;
        });
        EXPECT_EQ(count, block.sums[layer * profile_quantities(3)]);
    }
}

TEST(MeanFieldSums, AreTheSameBitsForAnyNumberOfThreads) {
    const auto sums_with = [](int threads) {
        set_thread_count(1);
        const Space channel(space_case());
        channel.advance(20);
        set_thread_count(threads);
        MeanField field(channel.parameters);
        ProfileSampler profiles(channel.parameters, &channel.column);
        TimeSeries series(channel.parameters);
        for (int k = 0; k < 3; ++k) {
            channel.advance(1);
            field.sample(*channel.simulation);
            profiles.sample(*channel.simulation);
            series.sample(*channel.simulation, 0.05);
        }
        set_thread_count(0);
        std::vector<double> all = all_sums(field);
        all.insert(all.end(), profiles.current().sums.begin(), profiles.current().sums.end());
        for (const SeriesColumn& column : series.columns()) {
            all.insert(all.end(), column.values.begin(), column.values.end());
        }
        return all;
    };
    const std::vector<double> one = sums_with(1);
    EXPECT_EQ(one, sums_with(2));
    EXPECT_EQ(one, sums_with(3));
}

TEST(MeanFieldWindows, GoOnFromACheckpoint) {
    Case c = space_case();
    const Space channel(c);
    channel.advance(1);
    // A window of some ten steps.
    c.output.mean_field_interval = 10.5 * channel.simulation->clock().time;
    MeanField straight(c);
    MeanField first(c);
    MeanField second(c);
    Content before;
    Content after;
    std::map<std::string, std::vector<float>> parts;
    const auto file = test::folder_of_this_process() / "mean-field-checkpoint.h5";
    for (int k = 0; k < 25; ++k) {
        channel.advance(1);
        straight.sample(*channel.simulation);
        (k < 14 ? first : second).sample(*channel.simulation);
        if (k == 13) {
            before = first.take_new_rows();
            for (const std::string& name : MeanField::field_names()) {
                parts[name] = floats(before, "/mean_field/" + name);
            }
            Content checkpoint;
            first.save(checkpoint);
            CheckpointFile::write(file, checkpoint);
            second.restore(CheckpointReader(file));
        }
    }
    const Content all = straight.take_new_rows();
    after = second.take_new_rows();
    EXPECT_EQ(straight.window_ends(), second.window_ends());
    ASSERT_GE(straight.window_ends().size(), 2U);
    EXPECT_EQ(all_sums(straight), all_sums(second));
    for (const std::string& name : MeanField::field_names()) {
        std::vector<float> joined = parts[name];
        const std::vector<float> rest = floats(after, "/mean_field/" + name);
        joined.insert(joined.end(), rest.begin(), rest.end());
        const std::vector<float> whole = floats(all, "/mean_field/" + name);
        ASSERT_EQ(joined.size(), whole.size());
        for (std::size_t i = 0; i < joined.size(); ++i) {
            EXPECT_TRUE(joined[i] == whole[i] || (std::isnan(joined[i]) && std::isnan(whole[i]))) << name;
        }
    }
    std::filesystem::remove(file);
}

TEST(MeanFieldWindows, HoldTheMeansOfTheirCells) {
    Case c = space_case();
    c.output.mean_field_spacing = 1.0;  // one cell for each row
    const Space channel(c);
    c.output.mean_field_interval = 1e-9;  // each sample is a window
    MeanField field(c);
    ProfileSampler profiles(c, &channel.column);
    channel.advance(5);
    field.sample(*channel.simulation);
    profiles.sample(*channel.simulation);
    const Content rows = field.take_new_rows();
    EXPECT_EQ(field.cells(), profiles.layers());
    const double volume =
        c.channel.length * c.channel.width * c.total_depth() / static_cast<double>(profiles.layers());
    for (std::size_t layer = 0; layer < profiles.layers(); ++layer) {
        const double* sums = &profiles.current().sums[layer * profile_quantities(3)];
        const auto mean = [&](LayerQuantity q) { return sums[static_cast<std::size_t>(q)] / sums[0]; };
        const double u = mean(LayerQuantity::u);
        const double v = mean(LayerQuantity::v);
        EXPECT_FLOAT_EQ(floats(rows, "/mean_field/count")[layer], static_cast<float>(sums[0]));
        EXPECT_FLOAT_EQ(floats(rows, "/mean_field/velocity")[layer], static_cast<float>(u));
        EXPECT_NEAR(floats(rows, "/mean_field/spanwise_velocity")[layer], v, 1e-9);
        EXPECT_NEAR(floats(rows, "/mean_field/velocity_spanwise_covariance")[layer],
                    mean(LayerQuantity::uv) - u * v, 1e-9);
        EXPECT_NEAR(floats(rows, "/mean_field/drag")[layer],
                    sums[static_cast<std::size_t>(LayerQuantity::drag_force)] / volume, 1e-4);
    }
}

TEST(SeriesInSpace, KnowTheSecondaryFlowAndTheCentreline) {
    const Space channel(space_case());
    channel.advance(10);
    TimeSeries series(channel.parameters);
    series.sample(*channel.simulation, channel.parameters.total_depth());
    const Particles<3>& p = channel.simulation->particles();
    double squares = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        squares += p.velocity[1][i] * p.velocity[1][i] + p.velocity[2][i] * p.velocity[2][i];
    }
    EXPECT_NEAR(series.last(fields::time_series.secondary_velocity),
                std::sqrt(squares / static_cast<double>(p.size())), 1e-12);
    // The strip of half a lattice period to each side is wider than this channel.
    EXPECT_NEAR(series.last(fields::time_series.centreline_velocity),
                series.last(fields::time_series.depth_mean_velocity), 1e-12);
    EXPECT_EQ(series.last(fields::time_series.side_wall_over_gravity), 0.0);
    Case half = space_case();
    EXPECT_DOUBLE_EQ(centreline_half_strip(half), 0.5 * std::sqrt(3.0) * half.bed.sphere_diameter);
    half.bed.kind = BedKind::no_slip;
    EXPECT_DOUBLE_EQ(centreline_half_strip(half), 0.05 * half.channel.width);
}

TEST(Snapshots, HoldTheChosenFieldsOfTheChosenParticles) {
    Case c = space_case();
    c.output.snapshot_fields = "pressure";
    c.output.snapshot_y = {0.01, 0.02};
    c.output.snapshot_z = {0.0, 0.03};
    const Space channel(c);
    channel.advance(2);
    SnapshotRecorder snapshots(c);
    snapshots.record(*channel.simulation);
    const std::size_t n = snapshots.entries().front().particles;
    const Content content = snapshots.take();
    const std::vector<float>& position = floats(content, snapshot_group(0) + "/position");
    ASSERT_EQ(position.size(), 3 * n);
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_GE(position[3 * i + 1], 0.00999F);
        EXPECT_LE(position[3 * i + 1], 0.02001F);
        EXPECT_LE(position[3 * i + 2], 0.03001F);
    }
    const Particles<3>& p = channel.simulation->particles();
    std::size_t expected = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto& [x, y, z] = p.position;
        expected += y[i] >= 0.01 && y[i] <= 0.02 && z[i] >= 0.0 && z[i] <= 0.03 ? 1 : 0;
    }
    EXPECT_EQ(n, expected);
    EXPECT_GT(n, 0U);
    EXPECT_EQ(floats(content, snapshot_group(0) + "/pressure").size(), n);
    EXPECT_THROW((void)floats(content, snapshot_group(0) + "/velocity"), std::logic_error);
    EXPECT_EQ(snapshots.bytes_per_particle(), 4U * (3 + 1 + 1));
}

}  // namespace
}  // namespace riffle::space_records_test
