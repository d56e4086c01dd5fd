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
/// | check and repair it | forefront::validate, forefront::repair |
/// | set the element size | forefront::SpacingSpec |
/// | mesh it | forefront::MeshingJob, forefront::meshDomain |
/// | step through a run, forward and back | forefront::MeshingSession |
/// | check a mesh | forefront::verify, forefront::verifyAgainst |
/// | measure its quality | forefront::measure, forefront::measureValues, forefront::judge |
/// | adapt a mesh to a field | forefront::adapt |
/// | read and write meshes | forefront::readMesh, forefront::writeMesh |
///
/// Nothing throws. A function that can fail returns a forefront::Result, which holds either the value or the
/// diagnostics: what is wrong, where, and how to fix it. Functions that take a forefront::Progress report how far they
/// are and can be cancelled from another thread.
#pragma once

#include "core/adapt/adaptive_meshing.hpp"
#include "core/arrangement/repair.hpp"
#include "core/base/version.hpp"
#include "core/domain/add_loop.hpp"
#include "core/domain/validate.hpp"
#include "core/io/files.hpp"
#include "core/mesh/limits.hpp"
#include "core/mesh/measures.hpp"
#include "core/mesh/quality.hpp"
#include "core/mesh/verify.hpp"
#include "core/mesher/pipeline.hpp"
#include "core/session/meshing_session.hpp"
