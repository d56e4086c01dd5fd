/// @file
/// The public interface of the drawing library, Forefront::drawing: drawings, maps and projects as domains, and the
/// repair of domains.
#pragma once

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/forefront.hpp"
