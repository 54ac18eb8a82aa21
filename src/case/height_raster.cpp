#include "case/height_raster.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

#ifdef RIFFLE_GEOTIFF

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace riffle::inline case_file {

namespace {

// Tags of GeoTIFF and of GDAL, and the keys of its directory that are looked at.
constexpr std::uint32_t pixel_scale_tag = 33550;
constexpr std::uint32_t tie_point_tag = 33922;
constexpr std::uint32_t transformation_tag = 34264;
constexpr std::uint32_t key_directory_tag = 34735;
constexpr std::uint32_t metadata_tag = 42112;
constexpr std::uint32_t no_data_tag = 42113;
constexpr std::uint16_t model_type_key = 1024;
constexpr std::uint16_t raster_type_key = 1025;
constexpr std::uint16_t linear_unit_key = 3076;

/// Heights of more places than this are refused, and so are strips or tiles of more bytes.
constexpr double most_heights = 1e8;
constexpr tmsize_t most_bytes_at_once = tmsize_t{256} * 1024 * 1024;

/// The content of a file as libtiff reads it, and the first fault that it found.
struct TiffSource {
    std::string_view content;
    std::size_t at = 0;
    std::string fault;
};

tmsize_t read_source(thandle_t handle, void* to, tmsize_t count) {
    auto& source = *static_cast<TiffSource*>(handle);
    const std::size_t left = source.content.size() - std::min(source.at, source.content.size());
    const std::size_t taken = std::min(left, static_cast<std::size_t>(count));
    std::memcpy(to, source.content.data() + std::min(source.at, source.content.size()), taken);
    source.at += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t write_source(thandle_t /*handle*/, void* /*from*/, tmsize_t /*count*/) { return 0; }

toff_t seek_source(thandle_t handle, toff_t offset, int whence) {
    auto& source = *static_cast<TiffSource*>(handle);
    const std::size_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? source.at : source.content.size();
    source.at = from + static_cast<std::size_t>(offset);
    return source.at;
}

int close_source(thandle_t /*handle*/) { return 0; }

toff_t size_of_source(thandle_t handle) { return static_cast<TiffSource*>(handle)->content.size(); }

int keep_fault(TIFF* /*tiff*/, void* user, const char* /*part*/, const char* format, va_list arguments) {
    std::string& fault = static_cast<TiffSource*>(user)->fault;
    if (fault.empty()) {
        std::array<char, 300> text{};
        static_cast<void>(std::vsnprintf(text.data(), text.size(), format, arguments));
        fault = text.data();
    }
    return 1;
}

int pass_over(TIFF* /*tiff*/, void* /*user*/, const char* /*part*/, const char* /*format*/,
              va_list /*arguments*/) {
    return 1;
}

/// One sample of an image as a number.
double sample_of(const std::uint8_t* at, std::uint16_t format, std::uint16_t bits) {
    const auto as = [&]<class T>(T value) {
        std::memcpy(&value, at, sizeof value);
        return static_cast<double>(value);
    };
    if (format == SAMPLEFORMAT_IEEEFP) {
        return bits == 64 ? as(double{}) : as(float{});
    }
    const bool is_signed = format == SAMPLEFORMAT_INT;
    switch (bits) {
        case 8:
            return is_signed ? as(std::int8_t{}) : as(std::uint8_t{});
        case 16:
            return is_signed ? as(std::int16_t{}) : as(std::uint16_t{});
        default:
            return is_signed ? as(std::int32_t{}) : as(std::uint32_t{});
    }
}

class RasterReader {
  public:
    RasterReader(std::string_view content, const std::string& name) : name_(name) {
        source_.content = content;
        const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                       &TIFFOpenOptionsFree);
        TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_bytes_at_once);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_fault, &source_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), pass_over, nullptr);
        // m: not mapped into memory, which the content is already.
        tiff_.reset(TIFFClientOpenExt(name.c_str(), "rm", &source_, read_source, write_source, seek_source,
                                      close_source, size_of_source, nullptr, nullptr, options.get()));
        if (!tiff_) refuse_raster("is not a TIFF file");
    }

    HeightGrid read() {
        read_kind();
        HeightGrid grid{.columns = width_, .rows = height_, .z = {}};
        place(grid);
        grid.z.assign(static_cast<std::size_t>(width_) * height_, std::numeric_limits<double>::quiet_NaN());
        if (TIFFIsTiled(tiff_.get()) != 0) {
            read_tiles(grid);
        } else {
            read_rows(grid);
        }
        return grid;
    }

  private:
    struct Closer {
        void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    };

    [[noreturn]] void refuse_raster(const std::string& what) const {
        throw FileError(fmt::format("{}: {}{}", name_, what,
                                    source_.fault.empty() ? "" : fmt::format(" ({})", source_.fault)));
    }

    /// The numbers of a tag that libtiff knows nothing of; empty where the file has none.
    template <class T>
    [[nodiscard]] std::vector<T> numbers(std::uint32_t tag) const {
        std::uint32_t count = 0;
        const T* values = nullptr;
        const TIFFField* const field = TIFFFindField(tiff_.get(), tag, TIFF_ANY);
        if (field == nullptr || TIFFFieldPassCount(field) == 0) {
            return {};
        }
        if (TIFFFieldReadCount(field) == TIFF_VARIABLE2) {
            if (TIFFGetField(tiff_.get(), tag, &count, &values) != 1) return {};
        } else {
            std::uint16_t few = 0;
            if (TIFFGetField(tiff_.get(), tag, &few, &values) != 1) return {};
            count = few;
        }
        const TIFFDataType expected = std::is_same_v<T, double> ? TIFF_DOUBLE
                                      : std::is_same_v<T, char> ? TIFF_ASCII
                                                                : TIFF_SHORT;
        if (TIFFFieldDataType(field) != expected || values == nullptr) {
            refuse_raster(fmt::format("its tag {} is of another type than GeoTIFF has", tag));
        }
        return {values, values + count};
    }

    /// A key of the directory of GeoTIFF whose value stands in the directory itself.
    [[nodiscard]] std::optional<int> geo_key(std::uint16_t key) const {
        const auto entries = numbers<std::uint16_t>(key_directory_tag);
        for (std::size_t i = 4; i + 3 < entries.size(); i += 4) {
            if (entries[i] == key && entries[i + 1] == 0) return entries[i + 3];
        }
        return std::nullopt;
    }

    void read_kind() {
        TIFF* const tiff = tiff_.get();
        std::uint16_t bands = 1;
        TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width_);
        TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height_);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &bands);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits_);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format_);
        if (width_ == 0 || height_ == 0) refuse_raster("holds an image without width or height");
        if (static_cast<double>(width_) * height_ > most_heights) {
            refuse_raster(
                fmt::format("holds {} x {} heights, expected at most {:.0e}: cut out what the channel needs",
                            width_, height_, most_heights));
        }
        if (bands != 1) {
            refuse_raster(fmt::format("holds {} bands: expected one, of heights", bands));
        }
        const bool whole = (format_ == SAMPLEFORMAT_UINT || format_ == SAMPLEFORMAT_INT) &&
                           (bits_ == 8 || bits_ == 16 || bits_ == 32);
        const bool floating = format_ == SAMPLEFORMAT_IEEEFP && (bits_ == 32 || bits_ == 64);
        if (!whole && !floating) {
            refuse_raster(
                fmt::format("holds samples of {} bits of format {}: expected whole numbers of 8, 16 or "
                            "32 bits, or floating ones of 32 or 64",
                            bits_, format_));
        }
        const auto none = numbers<char>(no_data_tag);
        if (!none.empty()) {
            const std::string text(none.begin(), std::find(none.begin(), none.end(), '\0'));
            char* end = nullptr;
            none_ = std::strtod(text.c_str(), &end);
            if (end == text.c_str()) refuse_raster("its GDAL_NODATA is not a number");
        }
        const auto metadata = numbers<char>(metadata_tag);
        const std::string_view text(metadata.data(), metadata.size());
        if (text.find("role=\"scale\"") != text.npos || text.find("role=\"offset\"") != text.npos) {
            refuse_raster(
                "its heights are scaled or shifted: write it with the true ones (gdal_translate -unscale)");
        }
    }

    /// Where the middles of the image's corners lie.
    void place(HeightGrid& grid) const {
        constexpr int projected = 1;
        constexpr int point = 2;
        const int model = geo_key(model_type_key).value_or(projected);
        if (model != projected) {
            refuse_raster(
                "its places are in degrees: project it onto a plane in metres first (gdalwarp -t_srs)");
        }
        const auto scale = numbers<double>(pixel_scale_tag);
        const auto tie = numbers<double>(tie_point_tag);
        const auto matrix = numbers<double>(transformation_tag);
        double x = 0.0;  // of the corner of the first pixel
        double y = 0.0;
        if (matrix.size() == 16) {
            if (matrix[1] != 0.0 || matrix[4] != 0.0) {
                refuse_raster("its image is turned: bring it north up first (gdalwarp)");
            }
            grid.step_x = matrix[0];
            grid.step_y = -matrix[5];
            x = matrix[3];
            y = matrix[7];
        } else if (scale.size() >= 2 && tie.size() == 6) {
            grid.step_x = scale[0];
            grid.step_y = scale[1];
            x = tie[3] - tie[0] * scale[0];
            y = tie[4] + tie[1] * scale[1];
        } else {
            refuse_raster(
                "says not where it lies: expected a GeoTIFF with ModelPixelScale and one ModelTiepoint, or "
                "a ModelTransformation");
        }
        const bool finite =
            std::isfinite(x) && std::isfinite(y) && std::isfinite(grid.step_x) && std::isfinite(grid.step_y);
        if (!finite || !(grid.step_x > 0.0 && grid.step_y > 0.0)) {
            refuse_raster("its pixels have no size above zero, north up");
        }
        const double half = geo_key(raster_type_key).value_or(1) == point ? 0.0 : 0.5;
        grid.x = x + half * grid.step_x;
        grid.y = y - (half + static_cast<double>(height_ - 1)) * grid.step_y;
        constexpr int metre = 9001;
        constexpr int foot = 9002;
        constexpr int survey_foot = 9003;
        switch (geo_key(linear_unit_key).value_or(0)) {
            case metre:
                grid.unit = 1.0;
                break;
            case foot:
                grid.unit = 0.3048;
                break;
            case survey_foot:
                grid.unit = 1200.0 / 3937.0;
                break;
            default:
                break;
        }
    }

    void set(HeightGrid& grid, std::size_t column, std::size_t row, const std::uint8_t* sample) const {
        const double z = sample_of(sample, format_, bits_);
        if (std::isinf(z)) {
            refuse_raster(
                fmt::format("the height of column {}, row {} from the north is infinite: mark what is "
                            "missing by GDAL_NODATA",
                            column + 1, row + 1));
        }
        if (!none_ || (z != *none_ && z != static_cast<double>(static_cast<float>(*none_)))) {
            grid.at(column, height_ - 1 - row) = z;
        }
    }

    [[nodiscard]] std::vector<std::uint8_t> buffer_of(tmsize_t bytes) const {
        if (bytes <= 0 || bytes > most_bytes_at_once) {
            refuse_raster("its strips or tiles are damaged, or larger than 256 MB");
        }
        return std::vector<std::uint8_t>(static_cast<std::size_t>(bytes));
    }

    void read_rows(HeightGrid& grid) {
        std::vector<std::uint8_t> row = buffer_of(TIFFScanlineSize(tiff_.get()));
        const std::size_t bytes = bits_ / 8U;
        if (row.size() < bytes * width_) refuse_raster("is damaged: a row is shorter than the image is wide");
        for (std::uint32_t j = 0; j < height_; ++j) {
            if (TIFFReadScanline(tiff_.get(), row.data(), j, 0) != 1) {
                refuse_raster(fmt::format("row {} from the north is damaged", j + 1));
            }
            for (std::size_t i = 0; i < width_; ++i) set(grid, i, j, row.data() + i * bytes);
        }
    }

    void read_tiles(HeightGrid& grid) {
        std::uint32_t across = 0;
        std::uint32_t down = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &across);
        TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &down);
        std::vector<std::uint8_t> tile = buffer_of(TIFFTileSize(tiff_.get()));
        const std::size_t bytes = bits_ / 8U;
        if (across == 0 || down == 0 || tile.size() / bytes / across < down) {
            refuse_raster("is damaged: a tile is smaller than it says");
        }
        for (std::uint32_t top = 0; top < height_; top += std::min(down, height_ - top)) {
            for (std::uint32_t left = 0; left < width_; left += std::min(across, width_ - left)) {
                if (TIFFReadTile(tiff_.get(), tile.data(), left, top, 0, 0) < 0) {
                    refuse_raster(fmt::format("the tile at column {}, row {} from the north is damaged",
                                              left + 1, top + 1));
                }
                for (std::size_t j = 0; j < std::min(down, height_ - top); ++j) {
                    for (std::size_t i = 0; i < std::min(across, width_ - left); ++i) {
                        set(grid, left + i, top + j, tile.data() + (j * across + i) * bytes);
                    }
                }
            }
        }
    }

    std::string name_;
    TiffSource source_;
    std::unique_ptr<TIFF, Closer> tiff_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    std::uint16_t bits_ = 1;
    std::uint16_t format_ = SAMPLEFORMAT_UINT;
    std::optional<double> none_;
};

}  // namespace

bool reads_rasters() { return true; }

HeightGrid parse_height_raster(std::string_view content, const std::string& name) {
    return RasterReader(content, name).read();
}

}  // namespace riffle::inline case_file

#else

namespace riffle::inline case_file {

bool reads_rasters() { return false; }

HeightGrid parse_height_raster(std::string_view /*content*/, const std::string& name) {
    throw FileError(fmt::format(
        "{}: this build of Riffle does not read GeoTIFF: build it with -D RIFFLE_GEOTIFF=ON, which needs libtiff "
        "(Debian: libtiff-dev), or write the heights as an ESRI ASCII grid (gdal_translate -of AAIGrid)",
        name));
}

}  // namespace riffle::inline case_file

#endif
