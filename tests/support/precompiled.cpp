// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Nothing: CMake makes a precompiled header only for a target with a source that uses it.
