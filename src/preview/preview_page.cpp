#include "preview/preview_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/markup.hpp"
#include "base/version.hpp"
#include "case/flow_kind.hpp"
#include "case/outline_check.hpp"
#include "case/words.hpp"
#include "preview/preview_views.hpp"
#include "report/page_assets.hpp"

namespace riffle::inline preview {

namespace {

constexpr double sheet_width = 1130.0;
constexpr double margin_left = 66.0;

/// The colours of the drawing, in a row.
void draw_legend(SvgSheet& sheet, const Case& c, double y) {
    double x = margin_left;
    const auto swatch = [&](const std::string& style, const std::string& text) {
        sheet.rectangle(x, y - 11.0, 18.0, 13.0, style);
        sheet.text(x + 24.0, y, text);
        x += 46.0 + 7.2 * static_cast<double>(text.size());
    };
    swatch(fmt::format(R"(fill="{}" stroke="{}")", water_colour, surface_colour), "water at its start");
    swatch("fill='url(#hatch)' stroke='#1b2026'", "bed and walls");
    if (!c.solids.empty()) {
        swatch(fmt::format(R"(fill="{}" stroke="#1b2026")", solid_colour(c, 0)), "solids");
    }
    if (!c.bed_patches.empty() || !c.surface_patches.empty()) {
        swatch(fmt::format(R"(fill="{0}" fill-opacity="0.75" stroke="{0}")", patch_colour),
               c.surface_patches.empty() ? "patches of the bed" : "patches of another roughness");
    }
    if (!c.vegetation.empty()) {
        swatch(fmt::format(R"(fill="{0}" fill-opacity="0.4" stroke="{0}")", stem_colour), "vegetation");
    }
    if (!c.porous.empty()) {
        swatch(fmt::format(R"(fill="{0}" fill-opacity="0.4" stroke="{0}")", porous_colour), "porous zones");
    }
    if (c.bed.roughness_height > 0.0) {
        swatch(R"(fill="#c2a878" fill-opacity="0.45" stroke="#8a6d3b" stroke-dasharray="3 3")",
               "roughness zone, datum (long dashes)");
    }
    if (c.channel.ends == Ends::open) {
        swatch(R"(fill="#0072b2" fill-opacity="0.35")", "water beyond the ends");
    }
    if (!c.probes.empty()) {
        swatch(fmt::format(R"(fill="{}")", probe_colour), "instruments, numbered as in the table");
    }
}

void draw_heading(SvgSheet& sheet, double x, double y, const std::string& title, const std::string& more) {
    sheet.text(x, y, title, R"(font-size="15" font-weight="600")");
    sheet.text(x + 9.0 * static_cast<double>(title.size()) + 6.0, y, more, R"(fill="#56606b")");
}

std::string larger(double exaggeration) {
    return exaggeration > 1.0 ? fmt::format("heights drawn {:g} times larger", exaggeration) : "to scale";
}

/// Lays out the views from above downward; returns the height of all of them.
class SheetLayout {
  public:
    SheetLayout(SvgSheet& sheet, const Case& c)
        : sheet_(sheet), c_(c), plan_(plan_preview(c)), space_(c.channel.dimensions == 3) {}

    double draw() {
        const double length = c_.channel.length;
        const double beyond =
            c_.channel.ends == Ends::open ? std::max(plan_.beside, 0.06 * length) : plan_.beside;
        const double wide = sheet_width - margin_left - (space_ ? 110.0 : 24.0);
        const ScaledView side = scaled_view(margin_left, y_ + 14.0, wide, 150.0, 400.0, -beyond,
                                            length + beyond, -plan_.below, plan_.top);
        std::string more = larger(side.exaggeration);
        if (space_) {
            more = fmt::format("cut A at y = {}, {}", plan_.unit.text(plan_.y), more);
        }
        if (c_.channel.slope > 0.0) {
            more += fmt::format("; x down the bed of slope {:.4g}", c_.channel.slope);
        }
        draw_heading(sheet_, margin_left, y_, "Side view", more);
        draw_side(sheet_, c_, plan_, side.view);
        y_ += side.view.height + 80.0;
        if (space_) {
            draw_plan_view(beyond, wide);
            draw_sections();
        }
        draw_window();
        draw_legend(sheet_, c_, y_);
        return y_ + 18.0;
    }

  private:
    void draw_plan_view(double beyond, double wide) {
        const double width = c_.channel.simulated_width();
        const double beside = std::min(plan_.beside, 0.08 * width);
        const ScaledView plan = scaled_view(margin_left, y_ + 14.0, wide, 60.0, 420.0, -beyond,
                                            c_.channel.length + beyond, -beside, width + beside);
        draw_heading(sheet_, margin_left, y_, "Plan",
                     plan.exaggeration > 1.0
                         ? fmt::format("widths drawn {:g} times larger", plan.exaggeration)
                         : std::string("to scale"));
        draw_plan(sheet_, c_, plan_, plan.view);
        y_ += plan.view.height + 80.0;
    }

    void draw_sections() {
        const double width = c_.channel.simulated_width();
        const double beside = std::min(plan_.beside, 0.08 * width);
        const double wide = (sheet_width - margin_left - 24.0 - 80.0) / 2.0;
        double tallest = 0.0;
        for (std::size_t k = 0; k < plan_.x.size(); ++k) {
            const double left = margin_left + static_cast<double>(k) * (wide + 80.0);
            const ScaledView view =
                scaled_view(left, y_ + 14.0, plan_.x.size() == 1 ? 1.3 * wide : wide, 110.0, 320.0, -beside,
                            width + beside, -plan_.below, plan_.top);
            draw_heading(sheet_, left, y_, "Cross-section",
                         fmt::format("cut {} at x = {}, {}", k == 0 ? "B" : "C", plan_.unit.text(plan_.x[k]),
                                     larger(view.exaggeration)));
            draw_section(sheet_, c_, plan_, view.view, plan_.x[k]);
            tallest = std::max(tallest, view.view.height);
        }
        y_ += tallest + 80.0;
    }

    /// A window of at most 48 by 20 spacings with the particles as they are placed.
    void draw_window() {
        const double spacing = c_.numerics.spacing;
        const double all = c_.channel.length + 2.0 * (c_.numerics.wall_layers + 1) * spacing;
        const double width = std::min(48.0 * spacing, all);
        const double pixels = 860.0 / 48.0 / spacing;
        const double height = 20.0 * spacing;
        const SheetPoint middle = particle_window(c_, width, height);
        const SheetView view{margin_left,
                             y_ + 14.0,
                             pixels * width,
                             pixels * height,
                             middle.x - 0.5 * width,
                             middle.x + 0.5 * width,
                             middle.y - 0.5 * height,
                             middle.y + 0.5 * height};
        SvgSheet window = sheet_;  // where there are too many, nothing is drawn
        draw_heading(window, margin_left, y_, "Particles",
                     space_ ? "those at the cut A as they are placed at the start, enlarged"
                            : "as they are placed at the start, enlarged");
        if (draw_particles(window, c_, plan_, view)) {
            sheet_ = std::move(window);
            y_ += view.height + 76.0;
        }
    }

    SvgSheet& sheet_;
    const Case& c_;
    PreviewPlan plan_;
    bool space_;
    double y_ = 30.0;
};

std::string row(const std::string& name, const std::string& value) {
    return fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escape_markup(name), escape_markup(value));
}

std::string bytes_text(double bytes) {
    return bytes >= 1e9   ? fmt::format("{:.3g} GB", 1e-9 * bytes)
           : bytes >= 1e6 ? fmt::format("{:.3g} MB", 1e-6 * bytes)
                          : fmt::format("{:.3g} kB", 1e-3 * bytes);
}

std::string time_text(double seconds) {
    return seconds >= 5400.0  ? fmt::format("{:.2g} h", seconds / 3600.0)
           : seconds >= 100.0 ? fmt::format("{:.2g} min", seconds / 60.0)
                              : fmt::format("{:.2g} s", seconds);
}

/// A length in the unit of the case's drawing.
std::string length_in(const Case& c, double length) { return SheetUnit::of(c.channel.length).text(length); }

std::string numbers_table(const Case& c, const Forecast* f) {
    std::string table = "<section><h2>Numbers</h2>\n<div class=\"scroll\"><table class=\"numbers\"><tbody>\n";
    table += row("kind of flow", flow_kind_name(flow_kind(c)));
    table += row("length, depth",
                 fmt::format("{}, {}", length_in(c, c.channel.length), length_in(c, c.channel.depth)));
    if (c.channel.dimensions == 3) table += row("simulated width", length_in(c, c.channel.simulated_width()));
    table += row("slope", fmt::format("{:.4g}", c.channel.slope));
    table += row("particle spacing, smoothing length",
                 fmt::format("{}, {}", length_in(c, c.numerics.spacing),
                             length_in(c, c.numerics.smoothing_ratio * c.numerics.spacing)));
    if (f != nullptr) {
        for (const auto& fact : f->end_facts) table += row(fact.label, fact.text);
        table += row("particles", fmt::format("{} of water, {} of walls", f->particles, f->wall_particles));
        table += row("sound speed", fmt::format("{:.4g} m/s", f->sound_speed));
        table += row("time step", fmt::format("{:.3g} s", f->time_step));
        table += row("simulated time", c.run.until == RunUntil::converged
                                           ? fmt::format("about {:.3g} s until converged, at most {:.3g} s",
                                                         f->end_time, f->latest_end)
                                           : fmt::format("{:.4g} s", f->end_time));
        table += row("steps", fmt::format("{:.3g}", f->steps));
        table += row("time here", fmt::format("about {}", time_text(f->wall_seconds)));
        table += row("memory at the peak", bytes_text(f->memory_bytes));
        table += row("disk at most", bytes_text(f->disk_bytes));
    }
    return table + "</tbody></table></div></section>\n";
}

std::string range_text(const Case& c, const Solid& solid, std::size_t axis) {
    const auto extent = extent_of(c, solid, axis);
    return extent ? fmt::format("{} to {}", length_in(c, extent->low), length_in(c, extent->high)) : "–";
}

std::string solids_table(const Case& c) {
    if (c.solids.empty()) return "";
    const bool space = c.channel.dimensions == 3;
    std::string table = fmt::format(
        "<section><h2>Solids</h2>\n<div class=\"scroll\"><table><thead><tr><th>name</th><th>shape</th><th>x</th>"
        "{}<th>z</th><th>surface</th><th>motion</th></tr></thead><tbody>\n",
        space ? "<th>y</th>" : "");
    for (const Solid& solid : c.solids) {
        table += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", escape_markup(solid.name),
                             word(solid.shape), range_text(c, solid, 0));
        table += space ? fmt::format("<td>{}</td>", range_text(c, solid, 1)) : "";
        table += fmt::format("<td>{}</td><td>{}</td><td>{}</td></tr>\n", range_text(c, solid, 2),
                             word(solid.surface), word(solid.motion));
    }
    table += "</tbody></table></div>\n";
    if (!c.solid_notes.empty()) {
        table += "<h3>What was made of the data</h3>\n<ul>\n";
        for (const std::string& note : c.solid_notes) {
            table += fmt::format("<li>{}</li>\n", escape_markup(note));
        }
        table += "</ul>\n";
    }
    return table + "</section>\n";
}

std::string places_text(const Case& c, const std::vector<double>& places) {
    if (places.empty()) return "–";
    constexpr std::size_t few = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), few); ++i) {
        text += (i > 0 ? ", " : "") + length_in(c, places[i]);
    }
    return text + (places.size() > few ? fmt::format(" and {} more", places.size() - few) : "");
}

std::string instruments_table(const Case& c, const Forecast* f) {
    std::string rows;
    for (std::size_t k = 0; k < c.probes.size(); ++k) {
        const Probe& probe = c.probes[k];
        rows += fmt::format(
            "<tr><td>{} {}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.4g} Hz</td></tr>\n", k + 1,
            escape_markup(probe.name), word(probe.kind), places_text(c, probe.x), places_text(c, probe.y),
            places_text(c, probe.z), probe.sampling_frequency);
    }
    if (f != nullptr) {
        for (const ProbeForecast& probe : f->probes) {
            if (probe.standard) {
                rows += fmt::format(
                    R"(<tr><td>{}</td><td>{}</td><td colspan="3">{} points, without being asked for</td><td>{:.4g} )"
                    "Hz</td></tr>\n",
                    escape_markup(probe.name), escape_markup(probe.kind), probe.points,
                    probe.sampling_frequency);
            }
        }
    }
    if (rows.empty()) return "";
    return "<section><h2>Instruments</h2>\n<div class=\"scroll\"><table><thead><tr><th>name</th><th>kind</th>"
           "<th>x</th><th>y</th><th>z</th><th>samples</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div></section>\n";
}

std::string warnings_box(const std::vector<std::string>& warnings) {
    if (warnings.empty()) return "";
    std::string box = "<div class=\"warnings\"><b>Warnings</b><ul>\n";
    for (const std::string& warning : warnings) {
        box += fmt::format("<li>{}</li>\n", escape_markup(warning));
    }
    return box + "</ul></div>\n";
}

std::string title_of(const Case& c) { return c.title.empty() ? c.path.filename().string() : c.title; }

}  // namespace

std::string preview_drawing(const Case& c) {
    SvgSheet sheet;
    const double height = SheetLayout(sheet, c).draw();
    return sheet.document(sheet_width, height, title_of(c));
}

std::string preview_page(const Case& c, const std::string& drawing, const Forecast* forecast,
                         const std::vector<std::string>& warnings) {
    const std::string title = escape_markup(title_of(c));
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
        "<meta name=\"generator\" content=\"{}\">\n<title>{}</title>\n<style>\n",
        escape_markup("Riffle " + version()), title);
    page += page_assets().style;
    page +=
        "\n.drawing { background: #fff; border: 1px solid var(--line); border-radius: 4px; overflow-x: auto; }\n"
        ".drawing svg { display: block; width: 100%; height: auto; min-width: 700px; }\n"
        ".numbers th, .numbers td { text-align: left; } .numbers { max-width: 60rem; }\n"
        "td { text-align: left; } thead th { text-align: left; }\n</style>\n</head>\n<body>\n<main>\n<header>\n";
    page += fmt::format("<p class=\"kicker\">Preview of {}, before any run</p>\n<h1>{}</h1>\n",
                        escape_markup(c.path.filename().string()), title);
    if (!c.description.empty()) {
        page += fmt::format("<p class=\"description\">{}</p>\n", escape_markup(c.description));
    }
    page += "</header>\n<section><div class=\"drawing\">\n" + drawing + "</div></section>\n";
    page += warnings_box(warnings) + numbers_table(c, forecast) + solids_table(c) +
            instruments_table(c, forecast);
    page += "</main>\n</body>\n</html>\n";
    return page;
}

}  // namespace riffle::inline preview
