#include "script/native_function.h"

#include <exception>
#include <utility>

#include "script/js_value.h"

namespace mjcourse {

namespace {

JSValueRef make_error(JSContextRef context, const char* message) {
  JSValueRef text = make_text(context, message);
  JSObjectRef error = JSObjectMakeError(context, 1, &text, nullptr);
  set_property(context, error, "id", make_text(context, "E-script-mujoco"));
  return error;
}

JSValueRef call(JSContextRef context, JSObjectRef function, JSObjectRef, std::size_t count,
                const JSValueRef arguments[], JSValueRef* exception) {
  try {
    auto* native = static_cast<NativeFunction*>(JSObjectGetPrivate(function));
    return (*native)(context, {arguments, count});
  } catch (const std::exception& error) {
    *exception = make_error(context, error.what());
    return JSValueMakeUndefined(context);
  }
}

void finalize(JSObjectRef function) {
  delete static_cast<NativeFunction*>(JSObjectGetPrivate(function));
}

JSClassRef native_class() {
  static const JSClassRef shared = [] {
    JSClassDefinition definition = {};
    definition.className = "NativeFunction";
    definition.callAsFunction = call;
    definition.finalize = finalize;
    return JSClassCreate(&definition);
  }();
  return shared;
}

}  // namespace

JSObjectRef make_function(JSContextRef context, NativeFunction function) {
  return JSObjectMake(context, native_class(), new NativeFunction(std::move(function)));
}

}  // namespace mjcourse
