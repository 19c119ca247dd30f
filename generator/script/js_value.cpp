#include "script/js_value.h"

#include <utility>

namespace mjcourse {

Protected::Protected(JSContextRef context, JSObjectRef object)
    : context_(context), object_(object) {
  JSValueProtect(context_, object_);
}

Protected::Protected(Protected&& other) noexcept
    : context_(other.context_), object_(std::exchange(other.object_, nullptr)) {}

Protected::~Protected() {
  if (object_ != nullptr) JSValueUnprotect(context_, object_);
}

JSValueRef make_text(JSContextRef context, const std::string& text) {
  return JSValueMakeString(context, JsString(text));
}

JSObjectRef make_empty_array(JSContextRef context) {
  return JSObjectMakeArray(context, 0, nullptr, nullptr);
}

std::string text_of(JSContextRef context, JSValueRef value) {
  JSStringRef string = JSValueToStringCopy(context, value, nullptr);
  if (string == nullptr) return "";
  std::string text(JSStringGetMaximumUTF8CStringSize(string), '\0');
  text.resize(JSStringGetUTF8CString(string, text.data(), text.size()) - 1);  // without the NUL
  JSStringRelease(string);
  return text;
}

JSValueRef property(JSContextRef context, JSObjectRef object, const std::string& name) {
  JSValueRef value = JSObjectGetProperty(context, object, JsString(name), nullptr);
  return value == nullptr ? JSValueMakeUndefined(context) : value;
}

void set_property(JSContextRef context, JSObjectRef object, const std::string& name,
                  JSValueRef value) {
  JSObjectSetProperty(context, object, JsString(name), value, kJSPropertyAttributeNone, nullptr);
}

JSObjectRef object_in(JSContextRef context, JSValueRef value) {
  if (!JSValueIsObject(context, value)) return nullptr;
  return JSValueToObject(context, value, nullptr);
}

}  // namespace mjcourse
