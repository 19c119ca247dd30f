// What is behind the mjcSimulation of the page.
#pragma once

#include "engine.h"
#include "physics/simulation.h"

struct mjcSimulation_ : mjcourse::Simulation {
  using Simulation::Simulation;
};
