// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/number_text.hpp"
#include "figures/wanted_figures.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

class WantedPage
{
  public:
    explicit WantedPage(WantedCurve const& found) : found_(found), rows_(figures::wanted_figures()), told_(rows_, found)
    {
    }

    [[nodiscard]] std::string text(std::vector<WrittenFile> const& written)
    {
        auto const& drive = found_.scene.drive;
        page_.line("{}: module {:g} mm, teeth {}/{}, {} waves, kinematics {}", drive.name, drive.module,
                   drive.flexspline_teeth, drive.circular_spline_teeth, found_.scene.wave_generator.waves,
                   to_string(found_.scene.solver.kinematics));
        page_.line("given: both teeth; computed: the neutral curve");
        page_.line("\nmesh, angles from the major axis");
        with_error("touch_begin");
        with_error("touch_end", "on the closed curve");
        with_error("parting", found_.ends);
        with_error("residual", "largest gap or overlap of the flanks there");
        page_.line("\nneutral curve");
        page_.figure(rows_["r_m"], found_, "undeformed");
        with_error("major_displacement", "rho - r_m");
        with_error("r_0", "mean radius");
        with_error("w0");
        page_.figure(
            rows_["displacement_error"], found_,
            "for flanks right to " + told_.with_unit("flank_error") + ", an error grows " + told_("growth") + " times");
        page_.figure(rows_["length_error"], found_);
        with_error("least_curvature");
        with_error("largest_curvature");
        with_error("bending_stress", "in the wall, by bending of the ring alone");
        with_error("smallest_clearance", "of both teeth, at u " + told_.with_unit("clearance_u"));
        page_.figure(rows_["inner_distance"], found_, "parallel to the neutral curve");
        write_notes(page_, found_.notes);
        write_end(written);
        return page_.text();
    }

  private:
    void with_error(char const* name, std::string const& note = "")
    {
        page_.figure(rows_[name], found_, told_.error_with_unit(name) + (note.empty() ? "" : ", " + note));
    }

    void write_end(std::vector<WrittenFile> const& written)
    {
        auto const shown = [](double seconds) {
            return figures::decimals<3>(figures::unit::millisecond.shown(seconds)) + " ms";
        };
        page_.line("\ntime, {} thread{}", found_.threads, plural(static_cast<std::size_t>(found_.threads)));
        for (StageTime const& entry : found_.timing)
            page_.figure(entry.stage, shown(entry.seconds));
        if (!written.empty())
            page_.line("\nwritten");
        for (WrittenFile const& file : written)
            page_.figure(file.kind, shown(file.seconds), file.file.string());
    }

    WantedCurve const& found_;
    figures::Rows<WantedCurve> rows_;
    Told<WantedCurve> told_;
    Page page_;
};

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(WantedCurve const& found, std::vector<WrittenFile> const& written)
{
    return report::WantedPage(found).text(written);
}

}  // namespace hdconj
