// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkPresetRepresentationProxy.h"

#include "InkParameter.h"
#include "vtkInkStyle.h"
#include "vtkSMInkDoubleVectorProperty.h"
#include "vtkSMInkIntVectorProperty.h"
#include "vtkSMInkIsoValueInitializationHelper.h"
#include "vtkSMInkRestoring.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// ParaView's properties of integers take no array of doubles.
void Set(vtkSMProxy* proxy, const std::string& property, const std::vector<double>& numbers)
{
  vtkSMPropertyHelper helper(proxy, property.c_str());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    helper.Set(static_cast<unsigned int>(i), numbers[i]);
  }
}

std::vector<double> Get(vtkSMProxy* proxy, const std::string& property)
{
  const vtkSMPropertyHelper helper(proxy, property.c_str());
  std::vector<double> numbers;
  for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i)
  {
    numbers.push_back(helper.GetAsDouble(i));
  }
  return numbers;
}

bool IsUnset(vtkSMProxy* proxy, const char* property)
{
  return vtkSMInkDoubleVectorProperty::SafeDownCast(proxy->GetProperty(property))->IsUnset();
}

} // namespace

vtkSMInkPresetRepresentationProxy::vtkSMInkPresetRepresentationProxy(
  vtkSmartPointer<vtkInkStyle> style, const Controls& controls)
  : Style(std::move(style))
  , Named(controls)
{
}

vtkSMInkPresetRepresentationProxy::~vtkSMInkPresetRepresentationProxy() = default;

bool vtkSMInkPresetRepresentationProxy::IsSlider(const std::string& name) const
{
  return std::find(this->Named.Sliders.begin(), this->Named.Sliders.end(), name) != this->Named.Sliders.end();
}

const InkParameter* vtkSMInkPresetRepresentationProxy::ParameterOf(const std::string& property) const
{
  const InkParameterTable& table = this->Style->GetParameterTable();
  const InkParameter* parameter = table.Find(property);
  return parameter || property.rfind(this->Named.Prefix, 0) != 0
    ? parameter
    : table.Find(property.substr(std::strlen(this->Named.Prefix)));
}

std::vector<double> vtkSMInkPresetRepresentationProxy::ValueOf(const std::string& property) const
{
  return this->ParameterOf(property)->Get(this->Style).Numbers;
}

int vtkSMInkPresetRepresentationProxy::ReadXMLAttributes(
  vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
{
  // There are not all properties yet.
  const vtkSMInkRestoring restoring(this);
  return this->Superclass::ReadXMLAttributes(manager, element);
}

void vtkSMInkPresetRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  // Before there is an input the person's own defaults are read.
  if (!flag || !name || this->Restoring > 0 || vtkSMPropertyHelper(this, "Input").GetNumberOfElements() == 0)
  {
    return;
  }
  const vtkSMInkRestoring restoring(this);
  if (std::string(name) == this->Named.Preset)
  {
    this->FollowPreset();
  }
  else if (this->IsSlider(name))
  {
    this->FollowSlider(name);
  }
  for (const Start& start : this->Named.Starts)
  {
    if (std::string(name) == start.Property && this->IsAutomatic(start))
    {
      vtkSMPropertyHelper(this, start.Switch).Set(start.On);
    }
    if (std::string(name) == start.Switch && this->IsOn(start) && IsUnset(this, start.Property))
    {
      this->SetStartValue(start);
    }
  }
}

void vtkSMInkPresetRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  const vtkSMInkRestoring restoring(this);
  for (const Start& start : this->Named.Starts)
  {
    const auto used = this->IsAutomatic(start)
      ? vtkSMInkIsoValueInitializationHelper::FindUsed(this, start.Surface)
      : std::nullopt;
    if (used)
    {
      vtkSMPropertyHelper(this, start.Property).Set(*used);
    }
  }
  // Sent at once: the switch alone changes nothing then.
  this->UpdateVTKObjects();
}

bool vtkSMInkPresetRepresentationProxy::ShowsChosen(vtkSMProperty* property)
{
  auto proxy = vtkSMInkPresetRepresentationProxy::SafeDownCast(property->GetParent());
  const std::string name = property->GetXMLName() ? property->GetXMLName() : "";
  return proxy &&
    std::any_of(proxy->Named.Starts.begin(), proxy->Named.Starts.end(),
      [&](const Start& start) { return name == start.Property && proxy->IsAutomatic(start); });
}

void vtkSMInkPresetRepresentationProxy::SetStartValue(const Start& start)
{
  if (start.Value == RANGE)
  {
    if (auto* input = vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(this, "Input").GetAsProxy()))
    {
      input->UpdatePipeline();
    }
    this->GetProperty(start.Property)->ResetToDomainDefaults();
  }
  else if (const std::optional<double> value =
             vtkSMInkIsoValueInitializationHelper::Suggest(this, this->Named.Array))
  {
    vtkSMPropertyHelper(this, start.Property).Set(*value);
  }
}

bool vtkSMInkPresetRepresentationProxy::IsOn(const Start& start)
{
  return vtkSMPropertyHelper(this, start.Switch).GetAsInt() == start.On;
}

bool vtkSMInkPresetRepresentationProxy::IsAsFollowed(vtkSMProperty* property)
{
  auto proxy = vtkSMInkPresetRepresentationProxy::SafeDownCast(property->GetParent());
  return !proxy || !property->GetXMLName() || proxy->IsAsFollowed(std::string(property->GetXMLName()));
}

bool vtkSMInkPresetRepresentationProxy::IsAsFollowed(const std::string& name)
{
  const auto start = std::find_if(this->Named.Starts.begin(), this->Named.Starts.end(),
    [&](const Start& one) { return name == one.Property; });
  if (start != this->Named.Starts.end())
  {
    return !this->IsOn(*start);
  }
  const std::vector<std::string> followers = this->GetFollowers();
  if (std::find(followers.begin(), followers.end(), name) == followers.end())
  {
    return true;
  }
  this->SetControls(!this->IsSlider(name));
  return Get(this, name) == this->ValueOf(name);
}

void vtkSMInkPresetRepresentationProxy::FollowPreset()
{
  this->SetControls(false);
  for (const std::string& name : this->GetFollowers())
  {
    Set(this, name, this->ValueOf(name));
  }
}

void vtkSMInkPresetRepresentationProxy::FollowSlider(const std::string& slider)
{
  this->SetControls(true);
  const std::vector<std::string> followers = this->GetFollowers();
  std::vector<const InkParameter*> parameters;
  for (const std::string& name : followers)
  {
    parameters.push_back(this->ParameterOf(name));
  }
  const auto valuesAt = [&](double position)
  {
    this->ParameterOf(slider)->Set(this->Style, { { position }, {} });
    std::vector<std::vector<double>> values;
    for (const InkParameter* parameter : parameters)
    {
      values.push_back(parameter->Get(this->Style).Numbers);
    }
    return values;
  };
  const auto low = valuesAt(0.0);
  const auto high = valuesAt(1.0);
  const auto here = valuesAt(vtkSMPropertyHelper(this, slider.c_str()).GetAsDouble());
  for (std::size_t i = 0; i < followers.size(); ++i)
  {
    // Only what the slider stands for: what was chosen for the others stays.
    if (followers[i] != slider && low[i] != high[i])
    {
      Set(this, followers[i], here[i]);
    }
  }
}

void vtkSMInkPresetRepresentationProxy::SetControls(bool sliders)
{
  const auto set = [&](const char* property)
  {
    const double number = vtkSMPropertyHelper(this, property).GetAsDouble();
    this->ParameterOf(property)->Set(this->Style, { { number }, {} });
  };
  set(this->Named.Preset);
  if (sliders)
  {
    std::for_each(this->Named.Sliders.begin(), this->Named.Sliders.end(), set);
  }
}

std::vector<std::string> vtkSMInkPresetRepresentationProxy::GetFollowers()
{
  std::vector<std::string> names;
  const auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(this->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    const std::string name = properties->GetKey();
    const bool starts = std::any_of(this->Named.Starts.begin(), this->Named.Starts.end(),
      [&](const Start& start) { return name == start.Property || name == start.Switch; });
    const bool tracked = vtkSMInkIntVectorProperty::SafeDownCast(property) ||
      vtkSMInkDoubleVectorProperty::SafeDownCast(property);
    if (tracked && !starts && name != this->Named.Preset)
    {
      names.push_back(name);
    }
  }
  return names;
}
