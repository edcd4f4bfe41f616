"""Every setting of every public class: what was set is got back, and only changes are changes."""

import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray

import pixelexact


def public_classes():
    for name in sorted(dir(pixelexact)):
        if name.startswith("vtk"):
            try:
                yield name, getattr(pixelexact, name)()
            except TypeError:
                pass  # abstract


def arguments(value):
    return value if isinstance(value, tuple) else (value,)


def another(value):
    """A value of the same kind that is in range wherever this one is in the middle."""
    if isinstance(value, tuple):
        return tuple(another(part) for part in value)
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value - 1 if value > 0 else value + 1
    if isinstance(value, float):
        return 0.5 * value + 0.1
    return value + "x"


class Settings(unittest.TestCase):
    def settings(self):
        for name, item in public_classes():
            own = [
                method
                for base in type(item).__mro__
                if base.__module__.startswith("pixelexact")
                for method in vars(base)
                if method.startswith("Set")
            ]
            for method in sorted(set(own)):
                getter = getattr(item, "Get" + method[3:], None)
                try:
                    value = getter() if getter else None
                except TypeError:
                    continue  # one of several, which the number names
                if isinstance(value, (bool, int, float, str, tuple)):
                    yield f"{name}.{method}", item, getattr(item, method), getter

    def test_same_values_are_no_change(self):
        checked = 0
        for name, item, setter, getter in self.settings():
            for turn in range(2):
                time = item.GetMTime()
                setter(*arguments(getter()))
                # A range that is set is chosen, even if it is the one that was shown.
                if name != "vtkHighOrderMapper.SetScalarRange" or turn > 0:
                    self.assertEqual(item.GetMTime(), time, name)
                try:
                    setter(*arguments(another(getter())))
                except TypeError:
                    break
            checked += 1
        self.assertGreater(checked, 80)

    def test_contour_values_are_no_change_either(self):
        for name, item in public_classes():
            if not hasattr(item, "SetContourValue"):
                continue
            with self.subTest(name):
                item.GenerateContourValues(3, 0.0, 1.0)
                time = item.GetMTime()
                item.GenerateContourValues(3, 0.0, 1.0)
                item.SetNumberOfContours(3)
                item.SetContourValue(1, 0.5)
                if hasattr(item, "SetContourValues"):
                    values = vtkDoubleArray()
                    for value in (0.0, 0.5, 1.0):
                        values.InsertNextValue(value)
                    item.SetContourValues(values)
                self.assertEqual(item.GetMTime(), time)
                item.SetContourValue(1, 0.25)
                self.assertGreater(item.GetMTime(), time)

    def test_changes_are_got_back(self):
        for name, item, setter, getter in self.settings():
            time = item.GetMTime()
            before = getter()
            try:
                setter(*arguments(another(before)))
            except TypeError:
                continue
            if getter() != before:
                self.assertGreater(item.GetMTime(), time, name)


if __name__ == "__main__":
    unittest.main()
