/// @file
/// The public interface of Forefront: this header and everything it includes.
///
/// @mainpage Forefront
/// Forefront fills a planar domain with triangles by the advancing front technique. The same input gives the same mesh
/// bit for bit, for any number of threads.
///
/// Ten lines mesh a rectangle and write it for Gmsh:
/// @code{.cpp}
/// #include <forefront/forefront.hpp>
///
/// int main() {
///     forefront::MeshingJob job;
///     forefront::addLoop(job.domain, std::vector<forefront::Vec2>{{0, 0}, {4, 0}, {4, 3}, {0, 3}});
///     job.spacing.expression = "0.05 + 0.1*x";
///     const auto outcome = forefront::meshDomain(job);
///     return outcome && !hasErrors(forefront::writeMesh("rectangle.msh", outcome->mesh)) ? 0 : 1;
/// }
/// @endcode
///
/// | to do | use |
/// |---|---|
/// | describe or read a domain | forefront::Domain, forefront::addLoop, forefront::readDomain |
/// | give it exact curves | forefront::Curve, forefront::CurveStretch |
/// | check it | forefront::validate |
/// | set the element size | forefront::SpacingSpec |
/// | mesh it | forefront::MeshingJob, forefront::meshDomain |
/// | step through a run, forward and back | forefront::MeshingSession |
/// | check a mesh | forefront::verify, forefront::verifyAgainst |
/// | measure its quality | forefront::measure, forefront::measureValues, forefront::judge |
/// | adapt a mesh to a field | forefront::adapt |
/// | read and write meshes | forefront::readMesh, forefront::writeMesh |
/// | read drawings, maps and projects; repair a domain | drawing.hpp, in Forefront::drawing |
///
/// A function that can fail returns a forefront::Result, which holds either the value or the diagnostics: what is
/// wrong, where, and how to fix it. Using the value of a failed result prints its first diagnostic and aborts.
/// Functions that take a forefront::Progress report how far they are and can be cancelled from another thread.
///
/// Only two kinds of exceptions leave the library: what the functions that you pass to it throw, and std::bad_alloc.
/// forefront::validate, meshDomain, adapt, verify, verifyAgainst and the functions that read and write files report the
/// error "out-of-memory" instead, and forefront::MeshingSession reports it in a snapshot.
#pragma once

#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/base/version.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/mesher/pipeline.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "core/files/files.hpp"
