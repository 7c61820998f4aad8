// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "base/text.hpp"
#include "judgement.hpp"
#include "limits.hpp"

namespace hdconj::judgement {

std::optional<Note> teeth_end(Scene const& scene, double front)
{
    double const half = *scene.circular_spline.width / 2;
    auto note = note_on(NoteCode::teeth_end, half - front);
    if (!note)
        return note;
    note->place = "circular_spline.width";
    note->cause = "the bent cup pulls its teeth back: at the major axis they end at z = " + short_number(front, 3) +
                  " mm, and the circular spline at " + short_number(half) + " mm; contact and force on its last " +
                  short_number(note->figure, 3) + " mm are computed although no tooth is there";
    constexpr double digits = 100;  // in a millimetre
    std::string const width = short_number(std::floor(digits * 2 * front) / digits);
    note->advice = "write circular_spline.width = " + width + ", or a larger flexspline.cup.tooth_width";
    note->set = {"circular_spline.width=" + width};
    return note;
}

}  // namespace hdconj::judgement
