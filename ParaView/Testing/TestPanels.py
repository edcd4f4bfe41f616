"""Panels explain themselves: each filter, reader and property has a text, and each entry a label."""

import glob
import html
import os
import re
import unittest

from paraview import servermanager, simple

import scene

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def proxies():
    """The plugin's own proxies: prototypes by group and name."""
    manager = servermanager.ProxyManager().SMProxyManager
    found = {}
    for name in glob.glob(os.path.join(FOLDER, "*.xml*")):
        with open(name) as file:
            text = file.read()
        for group, body in re.findall(r'<ProxyGroup name="(\w+)">(.*?)</ProxyGroup>', text, re.S):
            for proxy in re.findall(r'<\w*Proxy(?: group="\w+")?\s+name="(PixelExact\w*)"\s+(?:class|label)', body):
                prototype = manager.GetPrototypeProxy(group, proxy)
                if prototype is not None:
                    found[group, proxy] = prototype
    return found


def properties(proxy):
    """The properties that a panel may show."""
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        item = iterator.GetProperty()
        if not item.GetIsInternal() and item.GetPanelVisibility() != "never":
            yield iterator.GetKey(), item
        iterator.Next()


def text_of(item):
    documentation = item.GetDocumentation()
    return " ".join((documentation.GetDescription() or "").split()) if documentation is not None else ""


class Panels(unittest.TestCase):
    def setUp(self):
        simple.CreateView("RenderView")  # connects

    def test_texts(self):
        # ParaView's functions have its texts.
        found = {key: proxy for key, proxy in proxies().items() if key[0] != "implicit_functions"}
        self.assertGreater(len(found), 24)
        for (group, name), proxy in found.items():
            texts = {name: text_of(proxy)} | {
                key: text_of(item) for key, item in properties(proxy) if not item.GetInformationOnly()
            }
            for key, text in texts.items():
                with self.subTest(f"{group}.{name}: {key}"):
                    self.assertTrue(text, "a text")
                    self.assertTrue(text.endswith((".", ")", ":")), text)

    def test_labels(self):
        """No label is made of a name in one word."""
        for (group, name), proxy in proxies().items():
            for key, item in properties(proxy):
                with self.subTest(f"{group}.{name}: {key}"):
                    self.assertIsNone(re.search(r"[a-z][A-Z]", item.GetXMLLabel() or ""), item.GetXMLLabel())

    def test_menus(self):
        """All filters are in the menu PixelExact; the short texts are the tips of the menu."""
        for (group, name), proxy in proxies().items():
            if group not in ("filters", "sources"):
                continue
            with self.subTest(name):
                short = proxy.GetDocumentation().GetShortHelp()
                self.assertTrue(short and len(short) < 80, short)
                self.assertNotEqual(short, text_of(proxy), "the long text says more")
                if group == "filters":
                    menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
                    self.assertEqual(menu.GetAttribute("category"), "PixelExact")

    def test_help(self):
        """ParaView's help has a page of each filter and reader, where Qt's tools made them."""
        pages = os.path.join(scene.PICTURES, "..", "paraview_help")
        if not os.path.isdir(pages):
            self.skipTest("built without Qt's help tools")
        for (group, name), proxy in proxies().items():
            if group in ("filters", "sources"):
                with self.subTest(name), open(os.path.join(pages, f"{group}.{name}.html")) as file:
                    page = " ".join(html.unescape(file.read()).split())
                    for text in proxy.GetDocumentation().GetShortHelp(), text_of(proxy):
                        self.assertIn(text, page)

    def test_field_lists(self):
        """Fields are chosen from lists of the input's arrays; expressions have ParaView's calculator."""
        count = 0
        for (group, name), proxy in proxies().items():
            for key, item in properties(proxy):
                if key in ("Field", "OtherField", "ContourBy", "IsoField", "IsoArray", "Displacement"):
                    count += 1
                    with self.subTest(f"{name}: {key}"):
                        self.assertIsNotNone(item.FindDomain("vtkSMArrayListDomain"))
        self.assertGreater(count, 6)
        calculator = proxies()["filters", "PixelExactCalculator"]
        self.assertEqual(calculator.GetProperty("Function").GetPanelWidget(), "calculator")
        for needed in "AttributeType", "FunctionParserType":
            self.assertIsNotNone(calculator.GetProperty(needed), "read by ParaView's widget")

    def test_groups(self):
        """Lists of values stand under a title."""
        found = proxies()
        for key, title in (
            (("filters", "PixelExactContour"), "Contour Values"),
            (("representations", "UnstructuredGridRepresentation"), "Contours"),
        ):
            proxy = found.get(key) or servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy(*key)
            titles = [proxy.GetPropertyGroup(i).GetXMLLabel() for i in range(proxy.GetNumberOfPropertyGroups())]
            self.assertIn(title, titles)


if __name__ == "__main__":
    scene.main()
