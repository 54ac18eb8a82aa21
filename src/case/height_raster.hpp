#pragma once

#include <string>
#include <string_view>

#include "case/height_grid.hpp"

namespace riffle::inline case_file {

/// Whether this build reads GeoTIFF files: it was made with RIFFLE_GEOTIFF.
[[nodiscard]] bool reads_rasters();

/// Heights from the content of a GeoTIFF file, its first image: one band of whole or floating numbers in
/// strips or tiles, in any compression of libtiff, north up in a plane (OGC GeoTIFF 1.1). What is GDAL_NODATA
/// or NaN is missing. HeightGrid::unit is set where the file says its unit of length. `name` stands for it in
/// messages. FileError: a damaged file, one without places, in degrees, turned, of several bands, or of
/// scaled heights.
[[nodiscard]] HeightGrid parse_height_raster(std::string_view content, const std::string& name);

}  // namespace riffle::inline case_file
