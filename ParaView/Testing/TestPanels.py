"""Panels explain themselves: each filter, reader and property has a text, and each entry a label."""

import glob
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
            if group != "filters":
                continue
            with self.subTest(name):
                menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
                self.assertEqual(menu.GetAttribute("category"), "PixelExact")
                short = proxy.GetDocumentation().GetShortHelp()
                self.assertTrue(short and len(short) < 80, short)


if __name__ == "__main__":
    scene.main()
