#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/numbers.hpp"

namespace riffle::inline analysis {

/// Where the numbers of a curve come from; the report gives each origin one look throughout.
enum class Origin { simulated, measured, column, theory, fit, reference };

/// How a curve is drawn; `area`: as a filled outline, of a body say.
enum class Mark { line, points, line_and_points, bars, area };

/// A curve of a figure. `x` and `y` have the same length; not-a-number breaks the line. SI units.
struct Curve {
    std::string name;  ///< for the legend, e.g. "resolved Reynolds stress"
    Origin origin = Origin::simulated;
    Mark mark = Mark::line;
    std::vector<double> x, y;
    /// Half-widths of the 95 % intervals; empty where none is known.
    std::vector<double> x_half_width, y_half_width;
    /// Exact bounds of the 95 % intervals of y where these are lopsided, as of spectra; empty otherwise.
    std::vector<double> y_lower, y_upper;
    std::string run;  ///< name of the run or record it belongs to; empty where there is only one
    int variant = 0;  ///< tells apart curves of the same origin in one figure
};

/// A quantity over a plane, e.g. a space-time map. values[j * x.size() + i] belongs to (x[i], y[j]).
struct ColourMap {
    std::vector<double> x, y;
    std::vector<float> values;
    std::string label;  ///< of the values
    std::string unit;
    bool diverging = false;  ///< colours symmetric about zero
    bool logarithmic = false;
    std::string run;
    bool contours = false;  ///< with lines of equal value over the colours
};

/// Axis of a figure. The values are SI; `unit` is "1" for dimensionless ones.
struct Axis {
    std::string label;  ///< plain text with the symbol, e.g. "streamwise velocity u"
    std::string unit;   ///< SI: "m", "m/s", "Hz", "1"
    bool logarithmic = false;
    bool equal_scale = false;  ///< y: the same scale as x
    std::optional<double> from, to;
};

/// What a figure marks across its whole extent: a line at a value of one axis, or a band between two.
struct Guide {
    std::string name;   ///< e.g. "crests", "averaging window"
    bool on_x = false;  ///< at values of x, else of y
    double from = 0;    ///< SI
    double to = 0;      ///< the same as `from`: a line
};

/// One figure of an analysis: all that is needed to draw it, to write it as CSV and to compare runs in it.
struct Figure {
    std::string key;      ///< stable and unique, e.g. "velocity_profile"; also the name of its files
    std::string chapter;  ///< name of a Chapter, or "run"
    std::string title;
    std::string caption;  ///< what is drawn and from what, one to three sentences
    std::string source;   ///< the thesis' figure or equation, or the paper it follows; may be empty
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<ColourMap> maps;
    std::vector<Guide> guides;
    std::string missing;  ///< why there is nothing to draw; empty otherwise
};

/// One number found by the analysis.
struct Finding {
    std::string key;      ///< stable and unique, e.g. "surface_standard_deviation"
    std::string chapter;  ///< as of figures
    std::string label;    ///< e.g. "standard deviation of the surface elevation"
    std::string unit;
    double value = 0;
    std::optional<double> half_width;  ///< of the 95 % interval
    std::optional<double> reference;   ///< measured or theoretical value beside it
    std::string reference_name;        ///< e.g. "measured (thesis Table 3.1)"
    std::string remark;                ///< what it means, or why it differs
};

/// The window that was asked for in place of the run's own, and the run's summary over it.
struct AskedWindow {
    double from = 0.0;  ///< s
    double to = 0.0;    ///< s
    Numbers summary;
};

/// All that was found in one results file or laboratory record.
struct Analysis {
    std::string name;    ///< short, for legends: the title or the file's folder
    std::string source;  ///< the file
    std::vector<Finding> findings;
    std::vector<Figure> figures;
    std::vector<std::string> warnings;  ///< what the reader must know, e.g. a record too short
    std::optional<AskedWindow> asked_window;
};

}  // namespace riffle::inline analysis
