#pragma once

/// Keys of the chapters of an analysis (analysis/chapters.hpp has their titles).
namespace riffle::inline analysis::chapters {

inline constexpr const char* course = "course";
inline constexpr const char* along = "along";
inline constexpr const char* statistics = "statistics";
inline constexpr const char* profiles = "profiles";
inline constexpr const char* fits = "fits";
inline constexpr const char* surface = "surface";
inline constexpr const char* subsurface = "subsurface";
inline constexpr const char* forces = "forces";
inline constexpr const char* energy = "energy";
inline constexpr const char* section = "section";
inline constexpr const char* secondary = "secondary";
inline constexpr const char* bed = "bed";
inline constexpr const char* particles = "particles";

}  // namespace riffle::inline analysis::chapters
