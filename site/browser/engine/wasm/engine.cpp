#include "engine.h"

#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "allocation_scope.h"
#include "physics/model.h"
#include "physics/object_count.h"
#include "simulation_handle.h"

using mjcourse::load_model_files;
using mjcourse::ModelError;
using mjcourse::ModelFiles;

namespace {

ModelFiles files;       // for the next load
ModelError last_error;  // of the last load
std::string last_text;  // what was last returned as text

const char* keep(std::string text) {
  last_text = std::move(text);
  return last_text.c_str();
}

}  // namespace

void mjc_add_file(const char* name, const char* bytes, int size) {
  files[name].assign(bytes, static_cast<std::size_t>(size));
}

mjcSimulation* mjc_load(const char* name) {
  const ModelFiles given = std::exchange(files, {});
  AllocationScope scope;
  auto model = load_model_files(name, given);
  if (!model) {
    last_error = std::move(model.error());
    return nullptr;
  }
  try {
    // Room for what MuJoCo allocates in passing: memory is not to grow, and so to move, while the
    // page steps.
    mju_free(mju_malloc(1 << 20));
    auto* simulation = new mjcSimulation(*std::move(model));
    scope.keep();
    return simulation;
  } catch (const std::exception& error) {
    last_error = {name, 0, 0, error.what()};
    return nullptr;
  }
}

const mjcLoadError* mjc_load_error() {
  static mjcLoadError error;
  error = {last_error.file.c_str(), last_error.message.c_str(), last_error.cure.c_str(),
           last_error.line, last_error.column};
  return &error;
}

const char* mjc_warnings(const mjcSimulation* simulation) {
  std::string lines;
  for (const std::string& warning : simulation->model().warnings()) {
    lines += (lines.empty() ? "" : "\n") + warning;
  }
  return keep(std::move(lines));
}

void mjc_free(mjcSimulation* simulation) {
  delete simulation;
}

void mjc_step(mjcSimulation* simulation, int count) {
  simulation->step(count);
}

void mjc_forward(mjcSimulation* simulation) {
  simulation->forward();
}

void mjc_reset(mjcSimulation* simulation) {
  simulation->reset();
}

const char* mjc_reset_to_keyframe(mjcSimulation* simulation, int key) {
  auto done = simulation->reset_to_keyframe(key);
  return done ? nullptr : keep(std::move(done.error()));
}

const char* mjc_trouble(mjcSimulation* simulation) {
  return simulation->trouble() ? simulation->trouble()->what.c_str() : nullptr;
}

const char* mjc_exception_text(void* exception) {
  return keep(static_cast<std::exception*>(exception)->what());
}

mjModel* mjc_model(mjcSimulation* simulation) {
  return simulation->model().get();
}

mjData* mjc_data(mjcSimulation* simulation) {
  return simulation->data().get();
}

int mjc_object_count(const mjcSimulation* simulation, int type) {
  return mjcourse::object_count(*simulation->model().get(), static_cast<mjtObj>(type));
}
