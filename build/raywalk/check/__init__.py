"""What a student's picture is held against: right ones, wrong ones, what is seen where."""
