"""From scene files to the site: what each piece of work is made from, and who makes it when."""
