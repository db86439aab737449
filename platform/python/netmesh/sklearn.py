"""Diagrams as features, for scikit-learn."""
import functools
import warnings

import numpy as np
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_array, check_is_fitted

from ._arrays import whole
from ._persist import persist, rips
from ._series import delay
from .errors import InvalidArgument

try:  # scikit-learn 1.6
    from sklearn.utils.validation import validate_data
except ImportError:
    def validate_data(estimator, X, **options):
        return estimator._validate_data(X, **options)

_KINDS = ("landscape", "betti", "image", "statistics")
_STATISTICS = ("bars", "longest", "total", "entropy", "mean birth", "mean death")


class PersistenceFeatures(TransformerMixin, BaseEstimator):
    """Turns each sample into numbers that describe the persistence diagram of its points.

    X is either a sequence of samples, each an array [m, D] of points, D from 2 to 6 and the same for all, m of its own;
    or an array [samples, m] whose rows are series of numbers. One cloud is ``[cloud]``. A series x is taken as the
    points (x[i], x[i + delay], ..., x[i + (dimension - 1) * delay]), its delay embedding (:func:`netmesh.delay`): a
    periodic series is a circle.

    The grid of radii is that of the clouds that ``fit`` saw: of others what lies beyond its last radius is cut off.

    Parameters
    ----------
    features : "landscape", "betti", "image" or "statistics"
        Persistence landscapes, or numbers of bars that are alive, at ``resolution`` radii from 0 to the largest that
        ``fit`` has seen; or a persistence image, ``resolution`` births by ``resolution`` lengths of these: each bar is
        a normal distribution with a standard deviation of one step, weighted by its length; or six statistics of
        the finite bars: number, longest, total length, entropy of lengths, mean birth, mean death. Radii are in units
        of X.
    max_degree : int
        The highest degree of homology; each degree has features of its own.
    filter : str
        As of :func:`netmesh.persist`; "rips" is for any D.
    k : int or None
        Of the filters "knn" and "kdistance", which do not see single outliers: how many neighbours.
    layers : int
        How many layers of a landscape, the first for the longest bars.
    resolution : int
        At how many radii.
    dimension, delay : int
        Of the delay embedding of series; refused of clouds.

    Attributes
    ----------
    radii_ : ndarray [resolution]
        The radii of the grid.
    n_features_in_ : int
        m, of series.
    n_coordinates_ : int
        D, of point clouds.
    """

    def __init__(self, features="landscape", max_degree=1, filter="auto", layers=2, resolution=20, dimension=2,
                 delay=1, k=None):
        self.features = features
        self.max_degree = max_degree
        self.filter = filter
        self.layers = layers
        self.resolution = resolution
        self.dimension = dimension
        self.delay = delay
        self.k = k

    def fit(self, X, y=None):
        """Finds the largest radius of the samples' diagrams. Returns self."""
        if self.features not in _KINDS:
            raise InvalidArgument("features: %r is none of %s" % (self.features, ", ".join(_KINDS)), "features")
        self._largest(self._diagrams(X, reset=True))
        return self

    def fit_transform(self, X, y=None):
        """As ``fit(X).transform(X)``, with each diagram made once."""
        if self.features not in _KINDS:
            raise InvalidArgument("features: %r is none of %s" % (self.features, ", ".join(_KINDS)), "features")
        diagrams = self._diagrams(X, reset=True)
        self._largest(diagrams)
        return self._vectors(diagrams)

    def transform(self, X):
        """float64 [samples, features], in the order of :meth:`get_feature_names_out`."""
        check_is_fitted(self, "radii_")
        return self._vectors(self._diagrams(X, reset=False))

    def get_feature_names_out(self, input_features=None):
        """What each number is."""
        check_is_fitted(self, "radii_")
        names = []
        for degree in range(self.max_degree + 1):
            if self.features == "statistics":
                names += ["h%d %s" % (degree, name) for name in _STATISTICS]
                continue
            if self.features == "image":
                names += ["h%d image at birth %.6g, length %.6g" % (degree, birth, length)
                          for length in self.radii_ for birth in self.radii_]
                continue
            layers = range(self.layers) if self.features == "landscape" else (None,)
            for layer in layers:
                label = "h%d " % degree + ("betti" if layer is None else "landscape %d" % layer)
                names += ["%s at %.6g" % (label, radius) for radius in self.radii_]
        return np.asarray(names, dtype=object)

    def _largest(self, diagrams):
        largest = 0.0
        for diagram in diagrams:
            for degree in range(self.max_degree + 1):
                finite = self._bars(diagram, degree)
                largest = max(largest, finite.max()) if len(finite) else largest
        self.radii_ = np.linspace(0.0, largest, self.resolution)

    def _diagrams(self, X, reset):
        return [self._diagram(points) for points in self._clouds(X, reset)]

    def _clouds(self, X, reset):
        if _is_of_clouds(X):
            for name, default in (("dimension", 2), ("delay", 1)):
                if getattr(self, name) != default:
                    raise InvalidArgument("%s: of series alone, and X is clouds; of a series x give "
                                          "netmesh.delay(x, lag, dimension)" % name, name)
            clouds = [check_array(points) for points in X]
            self._check_coordinates([points.shape[1] for points in clouds], reset)
            return clouds
        series = validate_data(self, X, dtype=np.float64, reset=reset)
        if 2 <= series.shape[1] <= 6:
            warnings.warn("X: rows are taken as series, here of %d numbers; of one cloud give [cloud]" %
                          series.shape[1])
        whole(self.delay, "delay", 1)
        count = series.shape[1] - (whole(self.dimension, "dimension", 1) - 1) * self.delay
        if count < 1:
            raise ValueError("X: a series has %d feature(s), while a minimum of %d is required by the embedding."
                             % (series.shape[1], series.shape[1] + 1 - count))
        return [delay(row, self.delay, self.dimension) for row in series]

    def _check_coordinates(self, numbers, reset):
        if reset:
            self.n_coordinates_ = numbers[0]
        due = getattr(self, "n_coordinates_", numbers[0])
        for i, number in enumerate(numbers):
            if number != due:
                raise InvalidArgument("X[%d]: %d coordinates, where %s %d" % (
                    i, number, "X[0] has" if reset else "the clouds of fit had", due), "X")

    def _diagram(self, points):
        if self.filter == "rips":
            return rips(points, max_degree=self.max_degree)
        return persist(points, self.filter, max_degree=self.max_degree, k=self.k)

    def _bars(self, diagram, degree):
        if degree > diagram.max_degree:
            return np.empty((0, 2))
        bars = diagram.intervals(degree)
        return bars[np.isfinite(bars[:, 1])]

    def _vectors(self, diagrams):
        rows = [np.concatenate([self._vector(self._bars(diagram, degree)) for degree in range(self.max_degree + 1)])
                for diagram in diagrams]
        return np.array(rows)

    def _vector(self, bars):
        if self.features == "statistics":
            return _statistics(bars)
        births, deaths = bars[:, :1], bars[:, 1:]
        if self.features == "betti":
            return ((births <= self.radii_) & (self.radii_ < deaths)).sum(axis=0).astype(np.float64)
        if self.features == "image":
            return _image(bars, self.radii_)
        tents = np.minimum(self.radii_ - births, deaths - self.radii_).clip(min=0)
        layers = np.zeros((self.layers, len(self.radii_)))
        shown = min(self.layers, len(tents))
        layers[:shown] = -np.sort(-tents, axis=0)[:shown]
        return layers.ravel()


def _is_of_clouds(X):
    """Whether the items of X are clouds: of a list, an array [clouds, m, D], or one of objects, as of ragged clouds."""
    if isinstance(X, np.ndarray):
        return X.ndim == 3 or (X.ndim == 1 and X.dtype == object and len(X) > 0 and np.ndim(X[0]) == 2)
    return isinstance(X, (list, tuple)) and len(X) > 0 and np.ndim(X[0]) == 2


def _of_lists(method):
    """A method of X, called with an array in place of a list: scikit-learn 1.2 takes the method ``index`` of a list for
    the index of a frame where ``set_output`` asks for frames."""
    @functools.wraps(method)
    def call(self, X, *others, **named):
        if isinstance(X, (list, tuple)):
            X = _array_of_clouds(X) if _is_of_clouds(X) else np.asarray(X)
        return method(self, X, *others, **named)
    return call


def _array_of_clouds(X):
    clouds = np.empty(len(X), dtype=object)
    for i, points in enumerate(X):
        clouds[i] = np.asarray(points)
    return clouds


PersistenceFeatures.transform = _of_lists(PersistenceFeatures.transform)
PersistenceFeatures.fit_transform = _of_lists(PersistenceFeatures.fit_transform)


def _image(bars, radii):
    step = radii[1] - radii[0] if len(radii) > 1 and radii[1] > 0 else 1.0
    lengths = bars[:, 1] - bars[:, 0]
    by_birth = np.exp(-((radii[:, None] - bars[:, 0]) / step) ** 2 / 2)
    by_length = np.exp(-((radii[:, None] - lengths) / step) ** 2 / 2) * lengths
    return (by_length @ by_birth.T).ravel()


def _statistics(bars):
    if not len(bars):
        return np.zeros(len(_STATISTICS))
    lengths = bars[:, 1] - bars[:, 0]
    total = lengths.sum()
    shares = lengths / total
    entropy = -(shares * np.log(shares)).sum()
    return np.array([len(bars), lengths.max(), total, entropy, bars[:, 0].mean(), bars[:, 1].mean()])
