"""The terms of the course: what they mean, where texts have them, what is not to be said."""
