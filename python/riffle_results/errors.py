"""What goes wrong when a file is opened."""


class ResultsError(Exception):
    """A file is missing, not of Riffle, damaged, or of a version that this package does not know. The message names the
    file and says what to do."""
