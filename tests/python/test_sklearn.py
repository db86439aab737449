"""The transformer for scikit-learn."""
import warnings

import numpy as np
import pytest

pytest.importorskip("sklearn")
from sklearn.linear_model import LogisticRegression  # noqa: E402
from sklearn.pipeline import make_pipeline  # noqa: E402
from sklearn.preprocessing import StandardScaler  # noqa: E402
from sklearn.utils.estimator_checks import check_estimator  # noqa: E402

import netmesh  # noqa: E402
from netmesh.sklearn import PersistenceFeatures  # noqa: E402

from conftest import circle  # noqa: E402

KINDS = ("landscape", "betti", "image", "statistics")


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("estimator, check", [
    pair for kind in KINDS for pair in check_estimator(PersistenceFeatures(features=kind), generate_only=True)],
    ids=lambda thing: getattr(getattr(thing, "func", None), "__name__", None))
def test_estimator_checks(estimator, check):
    check(estimator)


def test_clouds_have_no_delay():
    clouds = [circle(20), circle(30)]
    for options, argument in ((dict(delay=8), "delay"), (dict(dimension=3), "dimension")):
        for call in ("fit", "fit_transform"):
            with pytest.raises(netmesh.errors.InvalidArgument, match="of series alone, and X is clouds") as raised:
                getattr(PersistenceFeatures(**options), call)(clouds)
            assert raised.value.argument == argument
    assert PersistenceFeatures(delay=8).fit_transform(np.sin(np.arange(80.0)).reshape(2, 40)).shape[0] == 2


@pytest.mark.parametrize("kind, count", [("landscape", 80), ("betti", 40), ("image", 800), ("statistics", 12)])
def test_features(kind, count):
    clouds = [circle(30, 0.05, seed) for seed in range(4)] + [circle(20, 0.3, 9)]
    made = PersistenceFeatures(kind).fit(clouds)
    numbers = made.transform(clouds)
    assert numbers.shape == (5, count) and np.isfinite(numbers).all()
    names = made.get_feature_names_out()
    assert len(names) == count and len(set(names)) == count
    assert (made.fit_transform(clouds) == numbers).all()
    assert (made.transform(np.stack(clouds[:4])) == numbers[:4]).all()
    assert PersistenceFeatures(kind, filter="rips").fit_transform(clouds).shape == (5, count)


def test_a_landscape_by_hand():
    square = [np.array([[0.0, 0], [2, 0], [0, 2], [2, 2]])]  # a bar of degree 1 from 1 to sqrt 2
    made = PersistenceFeatures(layers=1, resolution=5, filter="rips").fit(square)
    assert made.radii_ == pytest.approx(np.linspace(0, np.sqrt(2), 5))
    tent = np.minimum(made.radii_ - 1, np.sqrt(2) - made.radii_).clip(min=0)
    assert made.transform(square)[0, 5:] == pytest.approx(tent)
    betti = PersistenceFeatures("betti", resolution=5).fit(square).transform(square)[0]
    assert betti[:5] == pytest.approx([3, 3, 3, 0, 0])  # the essential one is left out


def test_an_image_by_hand():
    square = [np.array([[0.0, 0], [2, 0], [0, 2], [2, 2]])]
    made = PersistenceFeatures("image", resolution=5, filter="rips").fit(square)
    step, length = np.sqrt(2) / 4, np.sqrt(2) - 1
    births, lengths = np.meshgrid(made.radii_, made.radii_)
    due = length * np.exp(-(((births - 1) / step) ** 2 + ((lengths - length) / step) ** 2) / 2)
    assert made.transform(square)[0, 25:] == pytest.approx(due.ravel())


def test_neighbours_against_outliers():
    cloud = circle(40)
    with_outlier = np.concatenate((cloud, [[0.0, 0.0]]))
    longest = [PersistenceFeatures("statistics", filter="knn", k=4).fit_transform([points])[0, 7]
               for points in (cloud, with_outlier)]
    assert longest[1] == pytest.approx(longest[0], rel=0.1)
    assert PersistenceFeatures("statistics").fit_transform([with_outlier])[0, 7] < 0.7 * longest[0]


def test_series_that_repeat_are_circles():
    time = np.linspace(0, 1, 60)
    rng = np.random.default_rng(1)
    regular = [np.sin(2 * np.pi * (5 * time + shift)) + 0.05 * rng.normal(size=60) for shift in rng.random(20)]
    noise = [rng.normal(size=60) for _ in range(20)]
    X, y = np.array(regular + noise), np.repeat([1, 0], 20)
    features = PersistenceFeatures("statistics", dimension=2, delay=3)
    model = make_pipeline(features, StandardScaler(), LogisticRegression())
    model.fit(X[::2], y[::2])
    assert model.score(X[1::2], y[1::2]) >= 0.9


def test_series_are_embedded_as_delay_does():
    series = np.random.default_rng(1).normal(size=(2, 30))
    made = PersistenceFeatures(delay=4, dimension=3, filter="rips")
    clouds = [netmesh.delay(row, 4, 3) for row in series]
    assert (made.fit_transform(series) == PersistenceFeatures(filter="rips").fit_transform(clouds)).all()
    for options in (dict(delay=0), dict(dimension=0), dict(delay=1.5)):
        with pytest.raises(ValueError):
            PersistenceFeatures(**options).fit(series)


@pytest.mark.filterwarnings("ignore:points")
def test_one_cloud_is_not_taken_for_series_without_a_word():
    cloud = circle(20)
    for given in (cloud, cloud.tolist()):
        with pytest.warns(UserWarning, match=r"rows are taken as series, here of 2 numbers; of one cloud give \[cloud"):
            assert PersistenceFeatures().fit_transform(given).shape == (20, 80)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert PersistenceFeatures().fit_transform([cloud]).shape == (1, 80)
        PersistenceFeatures().fit(np.random.default_rng(1).normal(size=(3, 30)))


def test_clouds_have_the_same_number_of_coordinates():
    space = np.random.default_rng(1).normal(size=(20, 3))
    with pytest.raises(ValueError, match=r"X\[1\]: 3 coordinates, where X\[0\] has 2"):
        PersistenceFeatures().fit([circle(20), space])
    made = PersistenceFeatures().fit([circle(20)])
    assert made.n_coordinates_ == 2
    with pytest.raises(ValueError, match=r"X\[0\]: 3 coordinates, where the clouds of fit had 2"):
        made.transform([space])
    assert made.fit([space]).transform([space]).shape == (1, 80)  # anew


def test_arrays_of_objects():
    for clouds in ([circle(20), circle(30)], [circle(20), circle(20, 0.1)]):
        due = PersistenceFeatures().fit_transform(clouds)
        objects = np.empty(2, dtype=object)
        objects[0], objects[1] = clouds
        for given in (objects, np.array(clouds, dtype=object), tuple(clouds), [cloud.tolist() for cloud in clouds]):
            assert (PersistenceFeatures().fit_transform(given) == due).all()


def test_frames_out():
    pytest.importorskip("pandas")
    clouds = [circle(20), circle(30)]
    made = PersistenceFeatures("statistics").set_output(transform="pandas")
    for frame in (made.fit_transform(clouds), made.fit(clouds).transform(tuple(clouds))):
        assert list(frame.columns) == list(made.get_feature_names_out())
        assert (frame.to_numpy() == PersistenceFeatures("statistics").fit_transform(clouds)).all()
    assert list(made.fit_transform(np.eye(8).tolist()).index) == list(range(8))


def test_refusals():
    with pytest.raises(ValueError):
        PersistenceFeatures("cake").fit([circle(5)])
    with pytest.raises(ValueError):
        PersistenceFeatures().fit([[np.nan, 1.0], [1, 2]])
