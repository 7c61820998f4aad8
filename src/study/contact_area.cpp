// SPDX-License-Identifier: GPL-3.0-or-later
// Slices and flank points for the contact area.
#include <cmath>

#include "bench.hpp"
#include "hdconj/pipeline/contact.hpp"

namespace hdconj::detail {
namespace {

/// The scene as `contact` is asked for it, with an axis where it has none.
Scene coned(StudyBench const& bench)
{
    Scene scene = bench.drive.scene;
    double const width = scene.circular_spline.width.value_or(0);
    if (!scene.coning)
    {
        scene.coning.emplace();
        scene.coning->model = "linear";
        scene.coning->bottom_to_middle = 9.0 / 7.0 * width;   // as type-50 stands in its cup
        scene.coning->axial_shift = "mapped";
    }
    scene.tilt.reset();
    scene.slices.emplace();
    scene.slices->surface = "per-slice";
    if (!scene.contact)
    {
        scene.contact.emplace();
        scene.contact->gap = 0x1p-10;
    }
    return scene;
}

struct Setting
{
    int slices, points;
};

ContactState area(Scene scene, Setting const& setting)
{
    scene.slices->count = setting.slices;
    scene.contact->flank_points = setting.points;
    return contact(scene).cases.front().state;
}

}  // namespace

void study_contact(StudyBench const& bench)
{
    if (!bench.drive.scene.circular_spline.width)
    {
        bench.report.notes.push_back("contact-area: the scene gives no circular_spline.width, so there are no slices to count");
        return;
    }
    Scene scene = coned(bench);
    scene.solver.threads = bench.threads;
    struct Ladder
    {
        char const* method;
        char const* knob;
        std::vector<int> values;
        int finest;
        bool slices;
        int other;   ///< the count that stays: flank points, slices
    };
    // references as fine as can be asked for: a hundred times the flank points of the finest tested, fifteen times its slices
    std::vector<Ladder> const ladders = bench.quick ? std::vector<Ladder>{{"slices", "slices.count", {2, 3}, 9, true, 40}, {"flank points", "contact.flank_points", {20, 40}, 160, false, 3}}
                                                    : std::vector<Ladder>{{"slices", "slices.count", {2, 3, 5, 9, 17}, 257, true, 50},
                                                                          {"flank points", "contact.flank_points", {12, 25, 50, 100}, 10000, false, 3}};
    for (Ladder const& ladder : ladders)
    {
        auto const setting = [&](int value) { return ladder.slices ? Setting{value, ladder.other} : Setting{ladder.other, value}; };
        ContactState const finest = area(scene, setting(ladder.finest));
        double const truth = finest.contact_area;
        bench.report.notes.push_back("contact-area: no reference in 50 digits; " + std::string(ladder.method) + " are measured against "
                                     + std::to_string(ladder.finest) + " of them, whose own estimated error, that of " + std::to_string(ladder.other)
                                     + (ladder.slices ? " flank points" : " slices") + " included, is "
                                     + std::to_string(finest.share_error * finest.flank_area) + " mm^2");
        for (int const value : ladder.values)
        {
            ContactState const state = area(scene, setting(value));
            StudyRecord record;
            record.study = "contact-area";
            record.method = ladder.method;
            record.knob = ladder.knob;
            record.value = value;
            record.unit = "mm^2";
            record.error = std::abs(state.contact_area - truth);
            record.estimate = state.share_error * state.flank_area;
            record.points = static_cast<double>(setting(value).slices) * setting(value).points;
            record.threads = bench.threads;
            StudyBench few = bench;
            few.repeats = std::min(bench.repeats, 2);
            few.measure(record, [&] { (void)area(scene, setting(value)); });
        }
    }
}

}  // namespace hdconj::detail
