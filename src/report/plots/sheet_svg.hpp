// SPDX-License-Identifier: GPL-3.0-or-later
// A page of SVG, lengths in mm of the paper, y downwards.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::report {

/// Colours of a drawing.
namespace ink {
inline constexpr char const* black = "#000000";
inline constexpr char const* blue = "#0072b2";
inline constexpr char const* vermilion = "#d55e00";
inline constexpr char const* grey = "#888888";
}  // namespace ink

/// A part of the plane that is drawn into a square of the paper.
struct PaperView
{
    Vec2 corner = Vec2::Zero();  ///< upper left one on the paper
    double size = 1;             ///< of the square [mm]
    Vec2 centre = Vec2::Zero();  ///< of what is drawn [mm]
    double half = 1;             ///< half of its width [mm]

    [[nodiscard]] double scale() const { return size / (2 * half); }
    [[nodiscard]] Vec2 on_paper(Vec2 const& p) const
    {
        Vec2 const off = scale() * (p - centre);
        return corner + Vec2(size / 2 + off.x(), size / 2 - off.y());
    }
    [[nodiscard]] bool shows(Vec2 const& p) const { return (p - centre).cwiseAbs().maxCoeff() <= half; }
};

/// Grows element by element.
class SheetSvg
{
  public:
    SheetSvg(double width, double height)
        : text_(fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
                            "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n<rect width=\"{0}\" "
                            "height=\"{1}\" fill=\"#ffffff\"/>\n",
                            width, height))
    {
    }
    /// A square that clips what names it.
    void clip(std::string_view name, Vec2 const& corner, double size)
    {
        put("<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n", name, corner.x(),
            corner.y(), size, size);
    }
    void line(std::vector<Vec2> const& points, char const* colour, double width, char const* more = "")
    {
        std::string list;
        for (Vec2 const& p : points)
            list += fmt::format("{:.3f},{:.3f} ", p.x(), p.y());
        put("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" {}/>\n", list, colour, width,
            more);
    }
    void fill(std::vector<Vec2> const& points, char const* colour)
    {
        line(points, "none", 0, fmt::format("style=\"fill:{}\"", colour).c_str());
    }
    void circle(Vec2 const& centre, double radius, char const* colour, double width)
    {
        put("<circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:.3f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
            centre.x(), centre.y(), radius, colour, width);
    }
    /// @param style  attributes
    void text(Vec2 const& at, double size, std::string_view words, std::string_view style = "")
    {
        put("<text x=\"{:.3f}\" y=\"{:.3f}\" font-size=\"{:.3f}\" font-family=\"DejaVu Sans, sans-serif\" "
            "xml:space=\"preserve\" {}>{}</text>\n",
            at.x(), at.y(), size, style, escaped(words));
    }
    [[nodiscard]] std::string page() const { return text_ + "</svg>\n"; }

  private:
    template <class... Values>
    void put(fmt::format_string<Values...> pattern, Values&&... values)
    {
        fmt::format_to(std::back_inserter(text_), pattern, std::forward<Values>(values)...);
    }
    [[nodiscard]] static std::string escaped(std::string_view words)
    {
        std::string safe;
        for (char const c : words)
            safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
        return safe;
    }

    std::string text_;
};

}  // namespace hdconj::report
