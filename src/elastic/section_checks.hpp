// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the dimensions of a section; private to src/elastic.
#pragma once

#include <string>

#include "section_mesh.hpp"

namespace hdconj::elastic {

/// @throws NumericalError of the elastic cup with @p what and @p cause where @p good is false
void require(bool good, std::string const& what, std::string const& cause);

/// A length for a message.
[[nodiscard]] std::string mm(double length);

/// @throws NumericalError for values that cannot be meshed
void require_sound(Elasticity const& material);
void require_sound(MeshSize const& size);
void require_sound(CupSection const& cup);

/// Lengths over which the wall changes behind and in front of the tooth ring [mm].
[[nodiscard]] double rear_length(CupSection const& cup);
[[nodiscard]] double front_length(CupSection const& cup);

}  // namespace hdconj::elastic
