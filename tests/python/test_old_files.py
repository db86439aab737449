"""Files of version 0.2.0 and before, whose births and deaths were not rounded to nearest."""
import warnings

import pytest
from conftest import uniform

import netmesh
from netmesh import errors

TOLD = "made by netmesh 0.2.0 or before, whose births and deaths were not rounded to nearest; make the diagram again"


def test_old_files_are_told(tmp_path):
    points = uniform(2, 40)
    netmesh.persist(points, "alpha").save(tmp_path / "d.pers")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        netmesh.check(netmesh.load(tmp_path / "d.pers"), points)
    text = (tmp_path / "d.pers").read_text()
    assert "# reference" in text
    (tmp_path / "d.pers").write_text(text.replace("# reference", "# value-error 8.6e-12\n# reference"))
    with pytest.warns(UserWarning, match=TOLD):
        old = netmesh.load(tmp_path / "d.pers")
    with pytest.raises(errors.CheckFailed, match=TOLD) as raised:
        netmesh.check(old, points)
    assert raised.value.argument == "result"
