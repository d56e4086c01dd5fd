/// @file
/// The public interface of Forefront: this header and everything it includes.
///
/// @mainpage Forefront
/// Forefront fills a planar domain with triangles by the advancing front technique, and reads, judges and writes meshes
/// of triangles and quadrilaterals of both orders. The same input gives the same mesh
/// bit for bit, for any number of threads.
///
/// Nine lines mesh a rectangle and write it for Gmsh:
/// @code{.cpp}
/// #include <forefront/forefront.hpp>
///
/// int main() {
///     forefront::MeshingJob job;
///     forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
///     job.spacing.expression = "0.05 + 0.1*x";
///     const auto outcome = forefront::meshDomain(job);
///     return outcome && !hasErrors(forefront::writeMesh("rectangle.msh", outcome->mesh)) ? 0 : 1;
/// }
/// @endcode
///
/// | to do | use |
/// |---|---|
/// | describe a domain, or read one with its sizes | forefront::Domain, forefront::addLoop, forefront::readDomain |
/// | give it exact curves | forefront::Curve, forefront::CurveStretch |
/// | check it | forefront::validate |
/// | set the element size, also by a function | forefront::SpacingSpec, forefront::SizeGrid |
/// | set it at nodes and in regions, or count elements | forefront::PlacedSizes |
/// | add boundary layers | forefront::LayerSpec, forefront::LayerReport |
/// | divide two boundary parts alike | forefront::PeriodicSpec, forefront::periodicPairs |
/// | open cracks along inner lines | forefront::MeshingJob::cracks, forefront::CrackReport, forefront::closeCracks |
/// | fill faces by rows of elements | forefront::MappedSpec |
/// | give inner lines a width | forefront::StripSpec |
/// | choose the elements of a region | forefront::RegionElements |
/// | mesh it | forefront::MeshingJob, forefront::meshDomain |
/// | step through a run, forward and back | forefront::MeshStepper; in the background: forefront::MeshingSession |
/// | hold a mesh of any kinds of cells | forefront::Mesh, forefront::CellBlock, forefront::CellTraits |
/// | use the mesh as plain arrays | forefront::coordinates, forefront::connectivity |
/// | number its nodes for a small bandwidth | forefront::reverseCuthillMcKee, forefront::renumbered |
/// | split it into triangles | forefront::triangulated |
/// | make quadrilaterals of its triangles | forefront::recombine |
/// | find boundary parts and interfaces | forefront::edgesWithTag, forefront::edgeSides |
/// | check a mesh | forefront::verify, forefront::verifyAgainst |
/// | measure its quality | forefront::measureQuality, forefront::measureValues, forefront::checkLimits |
/// | find elements above the maximum area of a region | forefront::largeElements |
/// | adapt a mesh to a field | forefront::adaptMesh |
/// | read and write meshes | forefront::readMesh, forefront::writeMesh, forefront::checkElements |
/// | read drawings, maps and projects; repair a domain | drawing.hpp, in Forefront::drawing |
///
/// A function that can fail returns a forefront::Result, which holds either the value or the diagnostics: what is
/// wrong, where, and how to fix it. Using the value of a failed result prints its first diagnostic and aborts.
/// Functions that take a forefront::Progress report how far they are and can be cancelled from another thread.
///
/// Only two kinds of exceptions leave the library: std::bad_alloc, and only where "out-of-memory" is not among the
/// listed errors; and what your callbacks throw (a size function, a Progress, a NodalField), which reaches the caller
/// of the function that called them. A forefront::MeshingSession, whose caller is elsewhere, reports both as faults.
#pragma once

#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/base/version.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mesh/large_elements.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/mesh_access.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/run_estimate.hpp"
#include "core/engine/quads/recombine.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "core/engine/spacing/spec/size_grid.hpp"
#include "core/engine/spacing/spec/size_presets.hpp"
#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
