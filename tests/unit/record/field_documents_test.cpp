// The documents made from the tables of fields, and the tables themselves.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "record/field_tables.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "record/series_table.hpp"

namespace riffle::field_documents_test {
namespace {

const std::filesystem::path source_folder = RIFFLE_SOURCE_DIR;

std::string content(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST(FieldDocuments, PageAndListOfThePackageAreUpToDate) {
    EXPECT_EQ(content(source_folder / "docs/results-fields.md"), results_fields_markdown())
        << "stale: run `riffle schema --results --markdown -o docs/results-fields.md`";
    EXPECT_EQ(content(source_folder / "python/riffle_results/fields.json"), results_fields_json())
        << "stale: run `riffle schema --results -o python/riffle_results/fields.json`";
}

// Names are what files hold: two rows of one name must be of runs that exclude each other.
TEST(FieldTables, NamesAreUniqueInEachGroup) {
    for (const FieldTable& table : field_tables()) {
        for (std::size_t i = 0; i < table.fields.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const Field& one = table.fields[i];
                const Field& other = table.fields[k];
                if (std::string(one.name) != other.name || one.is_attribute() != other.is_attribute()) {
                    continue;
                }
                const unsigned both = one.written | other.written;
                const bool excluded = (both & section_twin && both & no_section_twin) ||
                                      (both & verlet_stepping && both & beeman_stepping);
                EXPECT_TRUE(excluded) << one.path();
            }
        }
    }
}

TEST(FieldTables, EveryRowSaysWhatItIs) {
    for (const FieldTable& table : field_tables()) {
        for (const Field& field : table.fields) {
            EXPECT_STREQ(field.group->path, table.group->path) << field.name;
            EXPECT_STRNE(field.meaning.in(2), "") << field.path();
            EXPECT_STRNE(field.meaning.in(3), "") << field.path();
            EXPECT_TRUE(field.is_attribute() || *field.unit.in(2) != '\0') << field.path();
        }
    }
}

TEST(FieldTables, GiveNamesAndPaths) {
    EXPECT_EQ(fields::time_series.mean_level.path(), "/time_series/mean_level");
    EXPECT_STREQ(fields::time_series.kinetic_energy.unit.in(2), "J/m");
    EXPECT_STREQ(fields::time_series.kinetic_energy.unit.in(3), "J");
    EXPECT_EQ(fields::velocity_points.velocity.path_in(probe_group("adv")), "/probes/adv/velocity");
    EXPECT_EQ(numbered_name(fields::solid_forces.lift, 2), "solid_lift_2");
}

TEST(SeriesTable, IsEmptyWhereTheRecordHasNone) {
    SeriesTable series;
    EXPECT_TRUE(series.empty());
    EXPECT_TRUE(series[fields::time_series.time].empty());
    series.set(fields::time_series.time, {0.0, 1.0});
    EXPECT_TRUE(series.has(fields::time_series.time));
    EXPECT_FALSE(series.has(fields::time_series.mean_level));
}

}  // namespace
}  // namespace riffle::field_documents_test
