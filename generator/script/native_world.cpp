#include "script/native_world.h"

#include <mujoco/mujoco.h>

#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "physics/field_table.h"
#include "physics/object_count.h"
#include "physics/simulation.h"
#include "script/js_value.h"
#include "script/mujoco_functions.h"
#include "script/native_function.h"

namespace mjcourse {

namespace {

struct Element {
  JSTypedArrayType type;
  std::size_t size;  // bytes
};

Element element_of(mjcFieldType type) {
  switch (type) {
    case mjcFIELD_DOUBLE:
      return {kJSTypedArrayTypeFloat64Array, sizeof(double)};
    case mjcFIELD_FLOAT:
      return {kJSTypedArrayTypeFloat32Array, sizeof(float)};
    case mjcFIELD_INT:
      return {kJSTypedArrayTypeInt32Array, sizeof(int)};
    default:
      return {kJSTypedArrayTypeUint8Array, 1};
  }
}

JSObjectRef view_of(JSContextRef context, const mjcField& field) {
  const auto [type, size] = element_of(field.type);
  const std::size_t count =
      static_cast<std::size_t>(field.rows) * static_cast<std::size_t>(field.columns);
  // an empty field may have no address, which the other constructor would refuse
  if (count == 0) return JSObjectMakeTypedArray(context, type, 0, nullptr);
  return JSObjectMakeTypedArrayWithBytesNoCopy(context, type, field.address, count * size, nullptr,
                                               nullptr, nullptr);
}

// A Table of site/press/script/field-table.ts.
JSObjectRef make_table(JSContextRef context, std::vector<mjcField> fields) {
  std::erase_if(fields, [](const mjcField& field) { return field.type == mjcFIELD_CHAR; });
  nlohmann::json rows = nlohmann::json::array();
  for (const mjcField& field : fields) {
    rows.push_back({field.owner, field.name, field.rows, field.columns, field.scalar != 0,
                    field.type == mjcFIELD_INT});
  }
  NativeFunction view = [fields = std::move(fields)](JSContextRef at,
                                                     std::span<const JSValueRef> index) {
    const double row = JSValueToNumber(at, index.front(), nullptr);
    return view_of(at, fields.at(static_cast<std::size_t>(row)));
  };
  JSObjectRef table = JSObjectMake(context, nullptr, nullptr);
  set_property(context, table, "rows", make_text(context, rows.dump()));
  set_property(context, table, "view", make_function(context, std::move(view)));
  return table;
}

std::vector<mjcField> model_fields(mjModel* model) {
  std::vector<mjcField> fields(static_cast<std::size_t>(mjc_model_fields(model, nullptr, 0)));
  mjc_model_fields(model, fields.data(), static_cast<int>(fields.size()));
  return fields;
}

std::vector<mjcField> data_fields(const mjModel* model, mjData* data) {
  std::vector<mjcField> fields(static_cast<std::size_t>(mjc_data_fields(model, data, nullptr, 0)));
  mjc_data_fields(model, data, fields.data(), static_cast<int>(fields.size()));
  return fields;
}

JSObjectRef make_names(JSContextRef context, const Model& model) {
  JSObjectRef names = JSObjectMake(context, nullptr, nullptr);
  for (const mjtObj kind : {mjOBJ_BODY, mjOBJ_XBODY, mjOBJ_JOINT, mjOBJ_GEOM, mjOBJ_SITE,
                            mjOBJ_CAMERA, mjOBJ_ACTUATOR, mjOBJ_SENSOR}) {
    JSObjectRef of_kind = make_empty_array(context);
    JSObjectSetPropertyAtIndex(context, names, static_cast<unsigned>(kind), of_kind, nullptr);
    for (int id = 0; id < object_count(*model.get(), kind); ++id) {
      JSValueRef name = make_text(context, model.name(kind, id));
      JSObjectSetPropertyAtIndex(context, of_kind, static_cast<unsigned>(id), name, nullptr);
    }
  }
  return names;
}

// A function that changes the simulation and throws what went wrong in it.
JSObjectRef make_mover(JSContextRef context, Simulation& simulation, void (*move)(Simulation&)) {
  return make_function(context, [&simulation, move](JSContextRef at, std::span<const JSValueRef>) {
    move(simulation);
    if (simulation.trouble()) throw std::runtime_error(simulation.trouble()->what);
    return JSValueMakeUndefined(at);
  });
}

}  // namespace

JSObjectRef make_native_world(JSContextRef context, Simulation& simulation) {
  mjModel* model = simulation.model().get();
  mjData* data = simulation.data().get();
  JSObjectRef native = JSObjectMake(context, nullptr, nullptr);
  const auto set = [&](const char* name, JSObjectRef value) {
    set_property(context, native, name, value);
  };
  set("modelTable", make_table(context, model_fields(model)));
  set("dataTable", make_table(context, data_fields(model, data)));
  set("names", make_names(context, simulation.model()));
  set("step", make_mover(context, simulation, [](Simulation& moved) { moved.step(); }));
  set("forward", make_mover(context, simulation, [](Simulation& moved) { moved.forward(); }));
  set("reset", make_mover(context, simulation, [](Simulation& moved) { moved.reset(); }));
  set("functions", make_mujoco_functions(context, simulation));
  return native;
}

}  // namespace mjcourse
