#include "script/mujoco_functions.h"

#include <mujoco/mujoco.h>

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "physics/object_count.h"
#include "physics/simulation.h"
#include "script/js_value.h"
#include "script/native_function.h"

namespace mjcourse {

namespace {

// How many numbers each array of a function has, in their order.
using Sizes = std::vector<std::size_t>;

// A call's arguments, taken one by one as the C parameter types ask for them. What the scripts'
// side has checked is checked again where memory depends on it.
struct Arguments {
  JSContextRef context;
  std::span<const JSValueRef> values;
  Simulation& simulation;
  std::span<const std::size_t> sizes;

  template <typename Parameter>
  Parameter take() {
    if constexpr (std::is_same_v<Parameter, const mjModel*>) {
      return simulation.model().get();
    } else if constexpr (std::is_convertible_v<mjData*, Parameter>) {
      return simulation.data().get();
    } else if constexpr (std::is_pointer_v<Parameter>) {
      return numbers(next());
    } else {
      return static_cast<Parameter>(JSValueToNumber(context, next(), nullptr));
    }
  }

  JSValueRef next() {
    if (values.empty()) throw std::invalid_argument("an argument is missing");
    JSValueRef value = values.front();
    values = values.subspan(1);
    return value;
  }

  // A Float64Array's memory, which nothing moves while this call lasts.
  mjtNum* numbers(JSValueRef value) {
    const std::size_t size = sizes.front();
    sizes = sizes.subspan(1);
    const bool doubles =
        JSValueGetTypedArrayType(context, value, nullptr) == kJSTypedArrayTypeFloat64Array;
    JSObjectRef array = doubles ? JSValueToObject(context, value, nullptr) : nullptr;
    if (array == nullptr || JSObjectGetTypedArrayLength(context, array, nullptr) != size) {
      throw std::invalid_argument("an array is not of " + std::to_string(size) + " numbers");
    }
    if (size == 0) return nullptr;
    auto* bytes = static_cast<std::byte*>(JSObjectGetTypedArrayBytesPtr(context, array, nullptr));
    bytes += JSObjectGetTypedArrayByteOffset(context, array, nullptr);
    return reinterpret_cast<mjtNum*>(bytes);
  }
};

template <typename Result, typename... Parameters>
NativeFunction bind(Simulation& simulation, Result (*function)(Parameters...), Sizes sizes) {
  return [&simulation, function, sizes = std::move(sizes)](JSContextRef context,
                                                           std::span<const JSValueRef> values) {
    Arguments arguments{context, values, simulation, sizes};
    // braces take the arguments in order
    const std::tuple<Parameters...> taken{arguments.take<Parameters>()...};
    if constexpr (std::is_void_v<Result>) {
      std::apply(function, taken);
      return JSValueMakeUndefined(context);
    } else {
      return JSValueMakeNumber(context, std::apply(function, taken));
    }
  };
}

void velocity_of_known_object(const mjModel* model, const mjData* data, int kind, int id,
                              mjtNum* velocity, int local) {
  const bool moves = kind == mjOBJ_BODY || kind == mjOBJ_XBODY || kind == mjOBJ_GEOM ||
                     kind == mjOBJ_SITE || kind == mjOBJ_CAMERA;
  if (!moves || id < 0 || id >= object_count(*model, static_cast<mjtObj>(kind))) {
    throw std::invalid_argument("mj_objectVelocity: there is no such object");
  }
  mj_objectVelocity(model, data, kind, id, velocity, local);
}

}  // namespace

JSObjectRef make_mujoco_functions(JSContextRef context, Simulation& simulation) {
  JSObjectRef functions = JSObjectMake(context, nullptr, nullptr);
  const auto add = [&](const char* name, auto* function, Sizes sizes) {
    set_property(context, functions, name,
                 make_function(context, bind(simulation, function, std::move(sizes))));
  };
  const auto nq = static_cast<std::size_t>(simulation.model().get()->nq);
  const auto nv = static_cast<std::size_t>(simulation.model().get()->nv);
  add("mj_differentiatePos", mj_differentiatePos, {nv, nq, nq});
  add("mj_integratePos", mj_integratePos, {nq, nv});
  add("mj_objectVelocity", velocity_of_known_object, {6});
  add("mj_energyPos", mj_energyPos, {});
  add("mj_energyVel", mj_energyVel, {});
  add("mj_mulM", mj_mulM, {nv, nv});
  add("mju_rotVecQuat", mju_rotVecQuat, {3, 3, 4});
  add("mju_negQuat", mju_negQuat, {4, 4});
  add("mju_mulQuat", mju_mulQuat, {4, 4, 4});
  add("mju_quatIntegrate", mju_quatIntegrate, {4, 3});
  add("mju_subQuat", mju_subQuat, {3, 4, 4});
  add("mju_quat2Vel", mju_quat2Vel, {3, 4});
  add("mju_axisAngle2Quat", mju_axisAngle2Quat, {4, 3});
  add("mju_normalize4", mju_normalize4, {4});
  return functions;
}

}  // namespace mjcourse
