#pragma once

/// The public interface of pliant, a particle solver for elastic solids and soft tissue.
#include <pliant/case_file.hpp>
#include <pliant/error.hpp>
#include <pliant/input.hpp>
#include <pliant/simulation.hpp>
#include <pliant/version.hpp>
